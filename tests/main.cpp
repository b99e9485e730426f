#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>
#include <gsl/gsl_errno.h>

#include <iostream>

#include "solvers/blas_threads.hpp"

namespace {

/// Counts the test cases for the closing line.
struct Count : doctest::IReporter {
    static inline unsigned passed = 0, failed = 0;

    explicit Count(const doctest::ContextOptions& /*options*/) {}
    void test_run_end(const doctest::TestRunStats& run) override {
        failed = run.numTestCasesFailed;
        passed = run.numTestCasesPassingFilters - failed;
    }
    void report_query(const doctest::QueryData& /*unused*/) override {}
    void test_run_start() override {}
    void test_case_start(const doctest::TestCaseData& /*unused*/) override {}
    void test_case_reenter(const doctest::TestCaseData& /*unused*/) override {}
    void test_case_end(const doctest::CurrentTestCaseStats& /*unused*/) override {}
    void test_case_exception(const doctest::TestCaseException& /*unused*/) override {}
    void subcase_start(const doctest::SubcaseSignature& /*unused*/) override {}
    void subcase_end() override {}
    void log_assert(const doctest::AssertData& /*unused*/) override {}
    void log_message(const doctest::MessageData& /*unused*/) override {}
    void test_case_skipped(const doctest::TestCaseData& /*unused*/) override {}
};
REGISTER_LISTENER("count", 1, Count);

}  // namespace

int main(int argc, char** argv) {
    gsl_set_error_handler_off();
    solvers::use_one_blas_thread();
    doctest::Context tests(argc, argv);
    const int result = tests.run();
    if (tests.shouldExit()) return result;
    std::cout << Count::passed << " passed, " << Count::failed << " failed\n";
    return Count::passed > 0 ? result : 1;
}
