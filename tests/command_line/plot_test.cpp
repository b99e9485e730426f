#include "command_line/plot.hpp"

#include "base/errors.hpp"
#include "tests/programs/run.hpp"
#include "tests/support/sanitizers.hpp"

using programs::check_refused;
using programs::Folder;
using programs::run;

namespace {

bool holds(const std::string& svg, const std::string& text) {
    return svg.find(text) != std::string::npos;
}

/// The figure that a command draws, which must be whole and the only file that it leaves.
std::string drawn(const std::string& command, const std::string& name = "figure.svg") {
    CAPTURE(command);
    const Folder folder;
    const std::string file = folder.path + "/" + name;
    const auto [code, output, errors] = run(command + " --plot \"" + file + "\"");
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK(output == run(command).output);
    CHECK(folder.entries() == 1);
    const std::string svg = report::read_whole(file);
    CHECK(svg.starts_with("<?xml"));
    CHECK(holds(svg, "\n</svg>"));
    return svg;
}

}  // namespace

TEST_CASE("plot: a whole figure with a curve for each formulation that was asked, and for no other") {
    for (const std::string command : {"derivative_test --particles 20,40", "static_test --particles 20,40",
                                      "vibration_test --particles 40"}) {
        const std::string svg = drawn(command + " --formulation fpm,second_order_fpm");
        CHECK(holds(svg, "FPM, applied twice"));
        CHECK(holds(svg, "second-order FPM"));
        CHECK(!holds(svg, "RKPM"));
    }
}

TEST_CASE("plot: one formulation, one number of particles, particles of one kind or of two") {
    for (const std::string program : {"derivative_test", "static_test"})
        for (const std::string options :
             {" --formulation second_order_fpm", " --particles 37", " --particles 20,40 --perturb 0,0.25",
              " --perturb 0.25 --seeds 3 --median --formulation ssph,second_order_fpm",
              " --particles 30 --perturb 0,0.2 --seeds 3 --median --formulation modified_fpm"})
            drawn(program + options);
    drawn("vibration_test --particles 3 --formulation fpm");
    drawn("vibration_test --particles 40 --formulation fpm,ssph --perturb 0.2");
    drawn("vibration_test --particles 40 --formulation fem_lumped");
}

TEST_CASE("plot: the key says the order of each curve where there is more than one number of particles") {
    const std::string two = " --formulation modified_fpm,second_order_fpm --particles 160,320";
    const std::string derivative = drawn("derivative_test" + two), displacement = drawn("static_test" + two);
    CHECK(holds(derivative, "modified FPM: order 1.0"));
    CHECK(holds(derivative, "second-order FPM: order 2.0"));
    CHECK(holds(displacement, "modified FPM: order 2.0"));
    CHECK(holds(displacement, "second-order FPM: order 1.98"));
    CHECK(holds(drawn("derivative_test --particles 160,320 --formulation original"),
                "original SPH: order −1.0"));
    CHECK(holds(drawn("plate --method strong,weak1 --particles 16x4,31x7"), "weak1: order 2."));
    CHECK(!holds(drawn("static_test --particles 160"), ": order"));
}

TEST_CASE("plot: the title says the user's function and parameters, whatever the file is called") {
    const std::string own = drawn(
        "derivative_test --particles 37 --function 'sin(5*x)+x^2' --kernel quintic_spline --smoothing 1.5",
        "it's {a} figure.svg");
    CHECK(holds(own, "B = sin(5*x)+x^2 on [0, 1]"));
    CHECK(holds(own, "kernel quintic_spline, h/delta 1.5"));
    CHECK(!holds(drawn("derivative_test --particles 37"), "kernel"));
    CHECK(holds(drawn("static_test --particles 53 --displacement 'x*exp(-x)'"), "u = x*exp(-x)"));
}

TEST_CASE("plot: the plate's errors against grids or scaling factors; else it says what can be drawn") {
    CHECK(holds(drawn("plate --method strong,weak1 --particles 13x4,16x4"), "1/15"));
    CHECK(holds(drawn("plate --method strong --scaling 3.5,4"), "scaling factor"));
    check_refused("plate --states bottom --plot /tmp/figure.svg", 2, "--plot draws errors");
    check_refused("plate --scaling 3,4 --particles 13x4,16x4 --plot /tmp/figure.svg", 2, "(as Figure 9)");
}

TEST_CASE(
    "plot: the stress along the axis of the hole, for the methods that were asked and the hole's radius") {
    const std::string svg = drawn("hole --states x2-axis --points 11 --method strong,weak1 --radius 0.5");
    CHECK(holds(svg, "weak1"));
    CHECK(!holds(svg, "weak2"));
    check_refused("hole --plot /tmp/figure.svg", 2, "add --states x2-axis");
    check_refused("hole --states x2-axis --draws 2 --plot /tmp/figure.svg", 2, "(as Figure 17)");
    check_refused("hole --states x2-axis --scaling 3,4 --plot /tmp/figure.svg", 2, "one value");
}

TEST_CASE("plot: the map of orders, the floors of the precisions, the spread over draws") {
    CHECK(holds(drawn("orders --from 1 --to 1.4 --seeds 1"), "h/δ"));
    CHECK(holds(drawn("roundoff --most 1000 --most-quad 100"), "quad"));
    const std::string svg = drawn("draws --particles 20 --seeds 40 --formulation fpm,second_order_fpm");
    CHECK(holds(svg, "percent of 40 draws"));
    CHECK(!holds(svg, "RKPM"));
    check_refused("roundoff --formulation ssph --plot /tmp/figure.svg", 2, "leave --formulation out");
}

TEST_CASE("plot: what cannot be drawn or written is refused before anything is computed") {
    const Folder folder;
    check_refused("static_test --particles 20 --plot " + folder.path + "/none/figure.svg", 1,
                  "none/figure.svg: No such file or directory");
    std::filesystem::create_directory(folder.path + "/folder.svg");
    check_refused("static_test --particles 20 --plot " + folder.path + "/folder.svg", 1, "Is a directory");
    check_refused("static_test --particles 20 --plot " + folder.path + "/figure.png", 2, ".svg");
    check_refused("static_test --perturb 0.1 --seeds 2 --plot " + folder.path + "/a.svg", 2, "--median");
    check_refused("static_test --perturb 0,0.1,0.2 --plot " + folder.path + "/a.svg", 2, "at most two");
    check_refused("vibration_test --particles 20,40 --plot " + folder.path + "/a.svg", 2, "one spectrum");
    CHECK(folder.entries() == 1);
    CHECK_THROWS_WITH_AS(
        command_line::check_plot({.script = "a/figure_1.gp", .path = folder.path + "/a.svg"}, "/nowhere"),
        doctest::Contains("/nowhere/figures/a/figure_1.gp"), base::FailedComputation);
}

// The sanitizer of threads keeps larger files of its own than the limit lets it.
TEST_CASE("plot: a drawing that the disk has no room for is no figure" *
          doctest::skip(support::threads_are_watched)) {
    const Folder folder;
    // No file may grow beyond 20 kB, and who tries hears of an error, not of a signal: to gnuplot, a full
    // disk.
    check_refused(
        "derivative_test --particles 20,40 --output /dev/null --plot " + folder.path + "/figure.svg", 1,
        "gnuplot left it unfinished; is the disk full?", "trap '' XFSZ; ulimit -f 40; ");
    CHECK(folder.entries() == 0);
}

TEST_CASE("plot: a table that cannot be drawn is written all the same") {
    const Folder folder;
    const std::string table = folder.path + "/table.csv",
                      command = "derivative_test --function 0 --particles 20,40";
    const auto drawn = run(command + " --output " + table + " --plot " + folder.path + "/figure.svg");
    CHECK(drawn.code == 1);
    CHECK(holds(drawn.errors, "cannot draw "));
    CHECK(report::read_whole(table) == run(command).output);
    CHECK(folder.entries() == 1);
}

TEST_CASE("plot: a script alone says which table it cannot read") {
    CHECK(holds(
        run("gnuplot -e \"table='/nowhere.csv'; output='/dev/null'\" figures/asprone2010/figure_1.gp").errors,
        "cannot draw /nowhere.csv: it cannot be read, or has no row of column names"));
}

TEST_CASE("plot: a request to end while gnuplot draws waits until temporary files are removed") {
    const Folder folder, programs;
    report::write_whole(
        programs.path + "/gnuplot",
        "#!/bin/sh\n[ $1 = --version ] && exit\nuntil [ -s $0.pid ]; do sleep 0.01; done\nkill -TERM "
        "$(cat $0.pid)\nls " +
            folder.path + " > $0.seen\n");
    std::filesystem::permissions(programs.path + "/gnuplot", std::filesystem::perms::owner_all);
    const auto ended =
        run("PATH=" + programs.path + ":$PATH; derivative_test --particles 20 --output /dev/null --plot " +
            folder.path + "/a.svg & echo $! > " + programs.path + "/gnuplot.pid; wait $!; echo $?");
    CHECK(ended.output == "143\n");
    CHECK(holds(report::read_whole(programs.path + "/gnuplot.seen"), "a.svg.tmp."));
    CHECK(folder.entries() == 0);
}

TEST_CASE("plot: gnuplot that is missing or complains is an error, and leaves nothing behind") {
    const Folder folder;
    const std::string file = folder.path + "/figure.svg";
    const auto missing = run("sh -c 'PATH=${PATH%%:*}; derivative_test --particles 20 --plot " + file + "'");
    CHECK(missing.code == 1);
    CHECK(holds(missing.errors, "gnuplot is needed for --plot; install it (apt-get install gnuplot-nox)"));

    report::write_whole(folder.path + "/gnuplot", "#!/bin/sh\n[ $1 = --version ] || echo oh >&2\n");
    std::filesystem::permissions(folder.path + "/gnuplot", std::filesystem::perms::owner_all);
    const auto complains =
        run("sh -c 'PATH=" + folder.path + ":$PATH; derivative_test --particles 20 --plot " + file +
            " --output /dev/null'");
    CHECK(complains.code == 1);
    CHECK(complains.errors ==
          "derivative_test: cannot draw " + file + ": gnuplot ended with code 0 and said: oh\n");
    CHECK(folder.entries() == 1);
}
