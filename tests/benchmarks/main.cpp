#include <omp.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <limits>
#include <map>
#include <vector>

#include "base/memory.hpp"
#include "report/file.hpp"
#include "report/table.hpp"
#include "solvers/blas_threads.hpp"
#include "tests/benchmarks/report.hpp"

namespace benchmarks {

namespace {

std::map<std::string, Task>& tasks() {
    static std::map<std::string, Task> all;
    return all;
}

std::string key(const Task& task) {
    return task.name + "/" + task.method + "/" + std::to_string(task.particles) + "/" +
           std::to_string(task.threads);
}

/// Gathers nanoseconds per particle, the least of the repetitions, while Google Benchmark runs.
class Collector : public benchmark::BenchmarkReporter {
  public:
    std::map<std::string, double> nanoseconds;

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.run_type == Run::RT_Aggregate || run.error_occurred) continue;
            const std::string name = run.run_name.function_name;
            const double each = run.real_accumulated_time / static_cast<double>(run.iterations) * 1e9 /
                                static_cast<double>(tasks().at(name).particles);
            const auto [known, fresh] = nanoseconds.emplace(name, each);
            if (!fresh) known->second = std::min(known->second, each);
            std::fprintf(stderr, "%-50s %12.2f ns per particle\n", name.c_str(), each);
        }
    }
};

report::Table table(const std::map<std::string, double>& nanoseconds, const std::vector<std::string>& order) {
    const auto limit = [&](const std::string& what, int threads) {
        const std::string prefix = "limit/" + what + "/";
        for (const auto& [name, each] : nanoseconds)
            if (name.starts_with(prefix) && tasks().at(name).threads == threads) return each;
        return std::numeric_limits<double>::quiet_NaN();
    };
    report::Table of;
    of.comments = {
        "nanoseconds per particle, the least of the repetitions, with the system's clearing of the pages that are written",
        "limit_bandwidth: the bytes at the bandwidth of a triad loop, limit_exp: the exponentials at the rate of a vectorised loop, both measured in the same run with as many threads",
        "numbers of one machine: make bench measures them anew"};
    of.columns = {{"task"},
                  {"method"},
                  {"particles"},
                  {"threads"},
                  {"nanoseconds", {0.01, 0}},
                  {"bytes", {0.01, 0}},
                  {"limit_bandwidth", {0.01, 0}},
                  {"limit_exp", {0.01, 0}}};
    const bool counted = std::any_of(order.begin(), order.end(),
                                     [](const std::string& name) { return tasks().at(name).operations > 0; });
    if (counted) of.columns.push_back({"operations", {0.01, 0}});
    for (const std::string& name : order) {
        const auto found = nanoseconds.find(name);
        if (found == nanoseconds.end()) continue;
        const Task& task = tasks().at(name);
        const bool limited = task.name != "limit";
        const double per_byte = limit("triad", task.threads) / 24, per_exp = limit("exp", task.threads);
        of.rows.push_back(
            {task.name, task.method, task.particles, static_cast<long>(task.threads), found->second,
             task.bytes > 0 ? report::Cell(task.bytes) : report::Cell(),
             limited && task.bytes > 0 ? report::Cell(task.bytes * per_byte) : report::Cell(),
             limited && task.exponentials > 0 ? report::Cell(task.exponentials * per_exp) : report::Cell()});
        if (!counted) continue;
        of.rows.back().emplace_back();
        if (task.operations > 0) of.rows.back().back() = task.operations;
    }
    return of;
}

}  // namespace

void add(const Task& task, const std::function<std::function<void()>()>& prepare) {
    const std::string name = key(task);
    tasks().emplace(name, task);
    auto* const registered = benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        omp_set_num_threads(task.threads);
        const auto work = prepare();
        if (task.particles >= 1000000) work();  // a virtual machine has its memory once it was used
        for (auto _ : state) work();
    });
    registered->UseRealTime()->Unit(benchmark::kMillisecond);
    if (task.once)
        registered->Iterations(1)->Repetitions(task.name == "assembly" ? 3 : 1);
    else
        registered->MinTime(0.3)->Repetitions(task.name == "limit" ? 9 : 3);
}

}  // namespace benchmarks

/// bench --part TEXT --most-1d N --most-2d N --output FILE [Google Benchmark's options]
int main(int argc, char** argv) {
    solvers::use_one_blas_thread();
    base::keep_freed_memory();  // as the programs do

    benchmark::Initialize(&argc, argv);
    std::map<std::string, std::string> option{
        {"--part", "asprone2010"}, {"--most-1d", "10000000"}, {"--most-2d", "100000"}, {"--output", ""}};
    for (int k = 1; k + 1 < argc; k += 2) {
        if (option.count(argv[k]) == 0) {
            std::cerr << "bench: there is no option '" << argv[k]
                      << "'; known are --part, --most-1d, --most-2d, --output\n";
            return 2;
        }
        option[argv[k]] = argv[k + 1];
    }
    benchmarks::add_limits();
    if (option["--part"] == "asprone2010")
        benchmarks::add_asprone2010(std::stol(option["--most-1d"]));
    else if (option["--part"] == "fpm_in_space")
        benchmarks::add_fpm_in_space();
    else
        benchmarks::add_batra2008(std::stol(option["--most-2d"]));

    benchmarks::Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    std::vector<std::string> order;
    for (const auto& [name, task] : benchmarks::tasks()) order.push_back(name);
    std::sort(order.begin(), order.end(), [](const std::string& a, const std::string& b) {
        const auto &left = benchmarks::tasks().at(a), &right = benchmarks::tasks().at(b);
        return std::tie(left.name, left.method, left.threads, left.particles) <
               std::tie(right.name, right.method, right.threads, right.particles);
    });
    if (std::none_of(order.begin(), order.end(), [&](const std::string& name) {
            return name.starts_with("limit/triad") && collector.nanoseconds.count(name) > 0;
        })) {
        std::cerr << "bench: without limit/triad there is no table; let the filter pass limit/\n";
        return 2;
    }
    const std::string csv = report::csv(benchmarks::table(collector.nanoseconds, order));
    if (option["--output"].empty())
        std::cout << csv;
    else
        report::write_whole(option["--output"], csv);
}
