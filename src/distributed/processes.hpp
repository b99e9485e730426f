#pragma once

#include <mpi.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "bodies/judgement.hpp"

namespace distributed {

/// The processes that work together: MPI's, or one without mpirun.
class Processes {
  public:
    explicit Processes(MPI_Comm communicator);

    [[nodiscard]] MPI_Comm communicator() const { return communicator_; }
    [[nodiscard]] int count() const { return count_; }
    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] bool is_first() const { return rank_ == 0; }

    /// Runs `work`, which must not communicate, on each process. If it fails on some, all throw the exception
    /// of the first of them, so that none waits for one that is gone.
    template <class Work>
    void together(const Work& work) const {
        Failure failure{none, ""};
        try {
            work();
        } catch (const base::InvalidInput& error) {
            failure = {invalid, error.what()};
        } catch (const std::bad_alloc&) {
            failure = {failed, "there is not enough memory on process " + std::to_string(rank_) +
                                   "; take more machines, or fewer processes on each"};
        } catch (const std::exception& error) {
            failure = {failed, error.what()};
        }
        throw_first(failure);
    }

    /// Whether something holds on all processes.
    [[nodiscard]] bool all(bool holds) const;
    [[nodiscard]] double sum(double number) const;
    [[nodiscard]] double largest(double number) const;
    /// Numbers of all processes, one after another, on each of them.
    [[nodiscard]] std::vector<double> gathered(const std::vector<double>& numbers) const;
    /// The number and the text of one process on each.
    [[nodiscard]] double from(int process, double number) const;
    [[nodiscard]] std::string from(int process, std::string text) const;
    /// The first process on which a number is least, or the largest.
    [[nodiscard]] int where_least(double number) const;
    [[nodiscard]] int where_largest(double number) const { return where_least(-number); }

    void send(const std::vector<char>& bytes, int to) const;
    [[nodiscard]] std::vector<char> receive(int from) const;

    /// The sums over all parts of a body. Additions have the order of the processes.
    template <int n>
    void combine(bodies::Sums<n>& sums) const {
        std::vector<double> own;
        const auto take = [&](double number) { own.push_back(number); };
        bodies::combine(sums, take, take);
        const std::vector<double> all = gathered(own);
        std::size_t place = 0;
        const auto combined = [&](double& number, const auto& with) {
            number = all[place];
            for (std::size_t other = place + own.size(); other < all.size(); other += own.size())
                number = with(number, all[other]);
            ++place;
        };
        bodies::combine(
            sums, [&](double& number) { combined(number, [](double a, double b) { return a + b; }); },
            [&](double& number) { combined(number, [](double a, double b) { return std::max(a, b); }); });
    }

  private:
    enum Kind { none, invalid, failed };
    struct Failure {
        Kind kind;
        std::string why;
    };
    /// \throws base::InvalidInput or base::FailedComputation where a process has failed
    void throw_first(const Failure& failure) const;

    MPI_Comm communicator_;
    int count_ = 1, rank_ = 0;
};

}  // namespace distributed
