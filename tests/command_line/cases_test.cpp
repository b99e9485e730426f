#include "command_line/cases.hpp"

#include "command_line/formulations.hpp"

#include "base/errors.hpp"
#include "tests/programs/run.hpp"

using namespace command_line;
using namespace programs;

extern "C" int openblas_get_num_threads();
extern "C" void openblas_set_num_threads(int threads);

TEST_CASE("cases: four numbers of particles for each doubling, from 10 to 2560") {
    const auto N = four_a_doubling();
    CHECK(N.front() == 10);
    CHECK(N.back() == 2560);
    for (std::size_t k = 0; k + 4 < N.size(); ++k) CHECK(std::abs(N[k + 4] - 2 * N[k]) <= 1);
    for (const long wanted : {320L, 640L, 1280L}) CHECK(std::find(N.begin(), N.end(), wanted) != N.end());
}

TEST_CASE("cases: cases run through formulations, perturbations, particles and seeds, in this order") {
    Options options;
    options.formulations = {"original", "fpm"};
    options.perturbations = {0, 0.25};
    options.particles = {10, 20};
    options.seed = 5;
    options.seeds = 3;
    const auto all = cases(options);
    REQUIRE(all.size() == 2 * (2 + 2 * 3));
    CHECK(all[0].formulation == "original");
    CHECK(all[0].perturbation == 0);
    CHECK(all[1].particles == 20);
    CHECK(all[2].perturbation == 0.25);
    CHECK(all[2].seed == 5);
    CHECK(all[4].seed == 7);
    CHECK(all[8].formulation == "fpm");
}

TEST_CASE("cases: all means every formulation, and an unknown name is refused") {
    Options options;
    options.particles = {10};
    CHECK(cases(options).size() == command_line::formulations().size());
    CHECK(cases(options, {"fem_lumped"}).size() == command_line::formulations().size() + 1);
    options.formulations = {"original", "fem_lumped"};
    CHECK_THROWS_AS(cases(options), base::InvalidInput);
    CHECK_NOTHROW(cases(options, {"fem_lumped"}));
}

TEST_CASE(
    "cases: --median gives medians and quartiles over the seeds, and is empty where a number is missing") {
    Options options;
    options.formulations = {"original"};
    options.particles = {11};
    options.perturbations = {0.1};
    options.seeds = 5;
    options.median = true;
    report::Table table;
    table.columns = {{"number"}, {"missing"}};
    tabulate(table, options, [](const Case& of) -> std::vector<report::Cell> {
        return {static_cast<double>(of.seed * of.seed), of.seed == 3 ? report::Cell() : report::Cell(1.0)};
    });
    CHECK(
        report::csv(table) ==
        "formulation,particles,spacing,perturbation,seed,number,missing,seeds,number_lower,number_upper,missing_lower,missing_upper\noriginal,11,0.1,0.1,1,9,,5,4,16,,\n");
}

TEST_CASE("cases: bad invocations end with code 2 and one line that names the cause") {
    for (const std::string program : {"derivative_test", "static_test", "vibration_test"}) {
        check_refused(program + " --formulation sph", 2,
                      "there is no formulation 'sph'; choose one of all, original");
        check_refused(program + " --particles 1", 2, "at least 2 particles, got 1");
        check_refused(program + " --particles -5", 2, "at least 2 particles, got -5");
        check_refused(program + " --particles abc", 2, "abc");
        check_refused(program + " --volumes half", 2, "there is no volume convention 'half'");
        check_refused(program + " --kernel gauss", 2, "there is no kernel 'gauss'");
        check_refused(program + " --smoothing 0", 2, "--smoothing must be positive and finite, got 0");
        check_refused(program + " --smoothing nan", 2, "--smoothing: 'nan' is no number");
        check_refused(program + " --perturb 0.5", 2, "take 0 <= a < 0.5");
        check_refused(program + " --seeds 0", 2, "--seeds");
        check_refused(program + " --threads 0", 2, "--threads");
        check_refused(program + " --seed 0", 2, "--seed");
        check_refused(program + " --seed 4294967296", 2, "--seed");
        check_refused(program + " --seed 4294967295 --seeds 2 --perturb 0.1", 2, "take a smaller --seed");
        check_refused(program + " --seed 7", 2, "--seed changes nothing without a perturbation");
        check_refused(program + " --formulation ssph --volumes partition", 2,
                      "--volumes changes nothing for ssph");
        check_refused(program + " --nonsense", 2, "--nonsense");
        check_refused(program + " file", 2, "file");
    }
}

TEST_CASE("cases: failed computations end with code 1 and one line that names cause and remedy") {
    check_refused(
        "derivative_test --formulation second_order_fpm --kernel cubic_spline --particles 20", 1,
        "second_order_fpm: particle 0 (x = 0) has 2 neighbours within 2h, needs 4; try --smoothing 1.6");
    check_refused("static_test --particles 10 --output /nowhere/file.csv", 1,
                  "cannot write /nowhere/file.csv: No such file or directory");
}

TEST_CASE("cases: an existing output stays as it is when a computation fails") {
    const Folder folder;
    const std::string file = folder.path + "/kept.csv";
    report::write_whole(file, "kept");
    check_refused(
        "derivative_test --formulation second_order_fpm --kernel cubic_spline --particles 20 --output " +
            file,
        1, "needs");
    CHECK(report::read_whole(file) == "kept");
}

TEST_CASE("cases: an option that a program has no use for is not offered") {
    for (const auto& [program, option] :
         {std::pair{"stencil", "--plot"}, {"stencil", "--median"}, {"vibration_test", "--median"}}) {
        CHECK(run(std::string(program) + " --help").output.find(option) == std::string::npos);
        check_refused(std::string(program) + " " + option, 2,
                      "there is no option '" + std::string(option) + "'");
    }
}

TEST_CASE("cases: --help shows every option and an example that runs") {
    for (const std::string program : {"derivative_test", "static_test", "vibration_test"}) {
        const auto [code, help, errors] = run(program + " --help");
        CHECK(code == 0);
        CHECK(errors.empty());
        for (const char* option : {"--formulation", "--particles", "--positions", "--volumes", "--kernel",
                                   "--smoothing ", "--smoothing-from", "--perturb", "--seed ", "--seeds",
                                   "--columns", "--threads", "--output", "(default "})
            CHECK(help.find(option) != std::string::npos);
        for (const std::string word : {"Example: ", "Another: "}) {
            const std::size_t example = help.find(word);
            REQUIRE(example != std::string::npos);
            const std::size_t start = example + word.size();
            const auto shown = run(help.substr(start, help.find('\n', example) - start));
            CHECK(shown.code == 0);
            CHECK(shown.output.starts_with("# Asprone et al. (2010)"));
        }
    }
}

TEST_CASE("cases: a program computes with one BLAS thread, so that its bytes do not depend on their number") {
    openblas_set_num_threads(2);
    CommandLine app("", "test");
    const Folder folder;
    Options options;
    options.output = folder.path + "/table.csv";
    std::string name = "test";
    char* arguments[] = {name.data(), nullptr};
    int threads = 0;
    CHECK(command_line::run(app, 1, arguments, options, [&] {
              threads = openblas_get_num_threads();
              return report::Table{{}, {{"a"}}, {}};
          }) == 0);
    CHECK(threads == 1);
}
