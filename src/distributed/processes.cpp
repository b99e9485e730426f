#include "distributed/processes.hpp"

#include <limits>

namespace distributed {

namespace {

constexpr int tag = 0;

}  // namespace

Processes::Processes(MPI_Comm communicator) : communicator_(communicator) {
    MPI_Comm_size(communicator, &count_);
    MPI_Comm_rank(communicator, &rank_);
}

void Processes::throw_first(const Failure& failure) const {
    int first = failure.kind == none ? count_ : rank_;
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, communicator_);
    if (first == count_) return;
    const bool was_invalid = from(first, failure.kind == invalid ? 1.0 : 0.0) != 0;
    const std::string why = from(first, failure.why);
    if (was_invalid) throw base::InvalidInput(why);
    throw base::FailedComputation(why);
}

bool Processes::all(bool holds) const {
    int everywhere = holds ? 1 : 0;
    MPI_Allreduce(MPI_IN_PLACE, &everywhere, 1, MPI_INT, MPI_MIN, communicator_);
    return everywhere == 1;
}

double Processes::sum(double number) const {
    double sum = 0;
    for (const double of_one : gathered({number})) sum += of_one;
    return sum;
}

double Processes::largest(double number) const {
    MPI_Allreduce(MPI_IN_PLACE, &number, 1, MPI_DOUBLE, MPI_MAX, communicator_);
    return number;
}

std::vector<double> Processes::gathered(const std::vector<double>& numbers) const {
    const auto each = static_cast<int>(numbers.size());
    std::vector<double> all(numbers.size() * static_cast<std::size_t>(count_));
    MPI_Allgather(numbers.data(), each, MPI_DOUBLE, all.data(), each, MPI_DOUBLE, communicator_);
    return all;
}

double Processes::from(int process, double number) const {
    MPI_Bcast(&number, 1, MPI_DOUBLE, process, communicator_);
    return number;
}

std::string Processes::from(int process, std::string text) const {
    auto letters = static_cast<int>(text.size());
    MPI_Bcast(&letters, 1, MPI_INT, process, communicator_);
    text.resize(static_cast<std::size_t>(letters));
    MPI_Bcast(text.data(), letters, MPI_CHAR, process, communicator_);
    return text;
}

int Processes::where_least(double number) const {
    struct {
        double number;
        int rank;
    } least{number, rank_};
    MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, communicator_);
    return least.rank;
}

void Processes::send(const std::vector<char>& bytes, int to) const {
    const unsigned long long size = bytes.size();
    MPI_Send(&size, 1, MPI_UNSIGNED_LONG_LONG, to, tag, communicator_);
    constexpr std::size_t most = 1U << 30U;  // MPI counts by int
    for (std::size_t first = 0; first < bytes.size(); first += most)
        MPI_Send(bytes.data() + first, static_cast<int>(std::min(most, bytes.size() - first)), MPI_CHAR, to,
                 tag, communicator_);
}

std::vector<char> Processes::receive(int from) const {
    unsigned long long size = 0;
    MPI_Recv(&size, 1, MPI_UNSIGNED_LONG_LONG, from, tag, communicator_, MPI_STATUS_IGNORE);
    std::vector<char> bytes(size);
    constexpr std::size_t most = 1U << 30U;
    for (std::size_t first = 0; first < bytes.size(); first += most)
        MPI_Recv(bytes.data() + first, static_cast<int>(std::min(most, bytes.size() - first)), MPI_CHAR, from,
                 tag, communicator_, MPI_STATUS_IGNORE);
    return bytes;
}

}  // namespace distributed
