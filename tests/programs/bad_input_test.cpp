#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <vector>

#include "tests/programs/run.hpp"
#include "tests/support/sanitizers.hpp"

using programs::check_refused;
using programs::Folder;
using programs::run;

namespace {

/// A program with its arguments as a shell reads them, the exit code, and a part of the message.
struct Bad {
    const char *program, *arguments;
    int code;
    const char* reason;
};

void check(const std::vector<Bad>& all) {
    for (const auto& [program, arguments, code, reason] : all)
        check_refused(std::string(program) + " " + arguments, code, reason);
}

/// The program succeeds without a message, and its table holds finite numbers only.
void check_finite(const std::string& command) {
    CAPTURE(command);
    const auto [code, output, errors] = run(command);
    CHECK(code == 0);
    CHECK(errors.empty());
    CHECK_FALSE(programs::has_non_finite_cell(output));
}

}  // namespace

TEST_CASE("bad input: numbers of particles that are none, too few, or more than can be held") {
    check({
        {"derivative_test", "--particles 0", 2, "--particles: a line needs at least 2 particles, got 0"},
        {"derivative_test", "--particles 1", 2, "at least 2 particles, got 1"},
        {"derivative_test", "--formulation modified_fpm --particles 2", 1, "take at least 3 particles"},
        {"derivative_test", "--formulation second_order_fpm --particles 3", 1, "take at least 4 particles"},
        {"derivative_test", "--particles -5", 2, "at least 2 particles, got -5"},
        {"derivative_test", "--particles 1e18", 2, "--particles: '1e18' is no whole number"},
        {"derivative_test", "--particles abc", 2, "--particles: 'abc' is no number"},
        {"derivative_test", "--particles nan", 2, "--particles: 'nan' is no number"},
        {"derivative_test", "--particles inf", 2, "--particles: 'inf' is no number"},
        {"derivative_test", "--particles ''", 2, "--particles is empty; give it a value or leave it out"},
        {"derivative_test", "--particles 40,020", 2, "--particles: '020' begins with 0; write it in decimal"},
        {"derivative_test", "--particles 0x20", 2, "'0x20' begins with 0; write it in decimal"},
        {"stencil", "--formulation fpm --particle 007", 2, "'007' begins with 0"},
        {"static_test", "--corrections 012", 2, "'012' begins with 0"},
        {"derivative_test", "--particles 999999999999", 2, "which holds at most 2147483647; take fewer"},
        {"derivative_test", "--particles 99999999999999999999", 2, "is no whole number up to 1e15"},
        {"derivative_test", "--particles 100000000", 2, "take fewer particles"},
        {"derivative_test", "--particles 100000 --smoothing 1e5", 2, "or a smaller --smoothing"},
        {"derivative_test", "--particles 100000000 --precision quad", 2, "take fewer particles"},
        {"static_test", "--particles 999999999999 --perturb 0.2", 2, "take fewer particles"},
        {"vibration_test", "--particles 999999999999", 2, "take fewer particles"},
        {"vibration_test", "--particles 1000000", 2, "GB; take fewer particles"},
        {"vibration_test", "--particles 2", 2, "take at least 3"},
        {"stencil", "--formulation fpm --particles 999999999999", 2, "take fewer particles"},
        {"stencil", "--formulation fpm --particle 1e18", 2,
         "--particle: '1e18' is no whole number up to 1e15"},
        {"stencil", "--formulation fpm --particle 99999999999", 2, "choose 0 to 49"},
        {"draws", "--particles 999999999999", 2, "take fewer particles"},
        {"draws", "--particles -5", 2, "at least 2 particles"},
        {"roundoff", "--most 1e9", 2, "--most must lie between 10 and 10000000, got 1000000000"},
        {"roundoff", "--most-quad -5", 2, "--most-quad must lie between 10 and 10000000, got -5"},
        {"plate", "--particles 0x0", 2, "a grid needs at least 2x2 particles, got 0x0"},
        {"plate", "--particles -5x4", 2, "at least 2x2"},
        {"plate", "--particles 1000000x1000000", 2, "take fewer particles or a smaller --scaling"},
        {"plate", "--particles 1e18x3", 2, "is no pair of whole numbers such as 16x4"},
        {"plate", "--particles nanx4", 2, "is no pair of whole numbers"},
        {"plate", "--particles ''", 2, "--particles is empty"},
        {"plate", "--method strong --states 1000000x1000000", 2, "places of --states take at least"},
        {"plate", "--method strong --states bottom --points 1e9", 2,
         "--points must lie between 2 and 1000000"},
        {"hole", "--method strong --states 1000001x1000001", 2, "'1000001x1000001' is no pair"},
        {"hole", "--layout polar-99999x99999", 2, "take fewer particles or a smaller --scaling"},
        {"hole", "--layout polar-0x0", 2, "a polar layout needs at least 3 rings"},
        {"hole", "--layout graded-0-0", 2, "at least 3 particles on the hole"},
        {"hole", "--layout graded-999999-999999", 2, "take more than 5053932 particles"},
        {"hole", "--layout graded-999999999999-3", 2, "there is no layout"},
    });
}

TEST_CASE("bad input: smoothing lengths, perturbations and other numbers beyond their meaning") {
    check({
        {"derivative_test", "--smoothing 0", 2, "--smoothing must be positive and finite, got 0"},
        {"derivative_test", "--smoothing -1", 2, "must be positive and finite, got -1"},
        {"derivative_test", "--smoothing nan", 2, "--smoothing: 'nan' is no number"},
        {"derivative_test", "--smoothing inf", 2, "--smoothing: 'inf' is no number"},
        {"derivative_test", "--smoothing 1e400", 2, "--smoothing: '1e400' is larger than a double can be"},
        {"derivative_test", "--smoothing ''", 2, "--smoothing is empty"},
        {"derivative_test", "--smoothing 0.01", 1, "try --smoothing"},
        {"derivative_test", "--formulation fpm --smoothing 1e300 --particles 40", 1,
         "the local system is singular"},
        {"vibration_test", "--formulation original --smoothing 1e3 --particles 20", 2,
         "take another --smoothing"},
        {"vibration_test", "--formulation original --smoothing 1e300 --particles 20", 2,
         "take another --smoothing"},
        {"constants", "--smoothing -1", 2, "take another --smoothing"},
        {"constants", "--smoothing 0", 2, "take another --smoothing"},
        {"constants", "--smoothing nan", 2, "'nan' is no number"},
        {"constants", "--smoothing 1e300", 2, "take another --smoothing"},
        {"constants", "--smoothing 30", 2, "not over 1 to 100; take another --smoothing"},
        {"static_test", "--formulation fpm --particles 40 --smoothing 20", 1,
         "is singular (reciprocal condition"},
        {"static_test", "--formulation fpm --particles 40 --smoothing 20 --precision long", 1, "is singular"},
        {"static_test", "--formulation fpm --particles 40 --smoothing 20 --precision quad", 1, "is singular"},
        {"derivative_test", "--perturb 0.5", 2, "take 0 <= a < 0.5"},
        {"derivative_test", "--perturb -1", 2, "take 0 <= a < 0.5"},
        {"derivative_test", "--perturb nan", 2, "--perturb: 'nan' is no number"},
        {"derivative_test", "--perturb ''", 2, "--perturb is empty"},
        {"derivative_test", "--seed 0", 2, "--seed must lie between 1 and 4294967295, got 0"},
        {"derivative_test", "--seed -1", 2, "--seed"},
        {"derivative_test", "--perturb 0.1 --seeds 1e12", 2,
         "--seeds must lie between 1 and 1000000, got 1000000000000"},
        {"derivative_test", "--seeds 9", 2, "add --perturb 0.25"},
        {"derivative_test", "--threads 0", 2, "--threads must lie between 1 and 1024, got 0"},
        {"derivative_test", "--threads 1000000", 2, "must lie between 1 and 1024"},
        {"derivative_test", "--median 3", 2, "'3' was not expected; see derivative_test --help"},
        {"draws", "--perturb inf", 2, "--perturb: 'inf' is no number"},
        {"draws", "--seeds 1", 2, "--seeds must lie between 2 and 1000000, got 1"},
        {"orders", "--from nan", 2, "--from: 'nan' is no number"},
        {"orders", "--to nan", 2, "--to: 'nan' is no number"},
        {"orders", "--step nan", 2, "--step: 'nan' is no number"},
        {"orders", "--step 1e-300", 2, "is no range of 1 to 1000 steps"},
        {"orders", "--to 1e300", 2, "is no range of 1 to 1000 steps"},
        {"orders", "--from -1", 2, "h/delta from -1 to 4 in steps of 0.2 is no range"},
        {"plate", "--scaling inf", 2, "--scaling: 'inf' is no number"},
        {"plate", "--scaling 1,,2", 2, "--scaling: '1,,2' has an empty entry; leave the comma beside it out"},
        {"plate", "--scaling 1:1e-300:2", 2, "of at most 10000 steps"},
        {"plate", "--scaling 1:1e-4:2 --poisson 0:1e-5:0.1 --penalty 1:1e-4:2", 2, "take shorter lists"},
        {"plate", "--degree 1e300", 2, "is no whole number"},
        {"plate", "--gauss 1e18", 2, "is no whole number"},
        {"plate", "--gauss -5", 2, "--gauss must lie between 1 and 1000"},
        {"plate", "--penalty -1", 2, "--penalty must be positive"},
        {"plate", "--poisson nan", 2, "--poisson: 'nan' is no number"},
        {"plate", "--test-scaling ''", 2, "--test-scaling is empty"},
        {"hole", "--radius 0", 2, "the hole's radius must lie between 0 and the side 3, got 0"},
        {"hole", "--radius -1", 2, "the hole's radius must lie between"},
        {"hole", "--radius 1e300", 2, "the hole's radius must lie between"},
        {"hole", "--radius 1e-300", 2, "take more than 8832 particles"},
        {"hole", "--draw 0", 2, "--draw must lie between 1 and 4000000000, got 0"},
        {"hole", "--draws 1e6", 2, "--draws must lie between 1 and 100000, got 1000000"},
    });
}

TEST_CASE("bad input: names that nothing has, options that are missing a value or do not exist") {
    check({
        {"derivative_test", "--formulation sph", 2, "choose one of all, original"},
        {"derivative_test", "--formulation ''", 2, "--formulation is empty"},
        {"derivative_test", "--formulation", 2, "--formulation needs a value; see derivative_test --help"},
        {"derivative_test", "--formulation ,", 2, "--formulation: ',' has an empty entry"},
        {"derivative_test", "--formulation all,fpm", 2, "--formulation all takes no other name beside it"},
        {"vibration_test", "--perturb 0.1 --seeds 2 --plot /tmp/a.svg", 2, "for each N; take one seed"},
        {"plate", "--seconds --states bottom", 2, "--seconds stand beside errors; leave --states out"},
        {"plate", "--method strong --scaling ',0.3'", 2,
         "--scaling: ',0.3' has an empty entry; leave the comma"},
        {"derivative_test", "--kernel cubic", 2, "choose one of gaussian"},
        {"derivative_test", "--volumes all", 2, "choose one of equal, partition"},
        {"derivative_test", "--smoothing-from here", 2, "choose one of mean, largest, local"},
        {"derivative_test", "--precision half", 2,
         "--precision: there is no precision 'half'; choose one of double, long, quad"},
        {"derivative_test", "--threads 1 --threads 2", 2, "--threads is given twice; give it once"},
        {"derivative_test", "--median=3", 2, "--median takes no value"},
        {"derivative_test", "--columns 2", 2, "--columns belongs to the file of --positions; add it"},
        {"hole", "--columns x,y", 2, "--columns belongs to a --layout FILE; name one"},
        {"choices", "--paper nobody1999", 2, "--paper: there is no 'nobody1999'; choose one of asprone2010"},
        {"derivative_test", "--config x", 2, "there is no option '--config'; see derivative_test --help"},
        {"derivative_test", "\"$(printf '%s\\n.' --kernel)\"", 2, "there is no option '--kernel?.'"},
        {"derivative_test", "--kernel \"$(printf '\\033[31m\\nred')\"", 2, "there is no kernel '?[31m?red'"},
        {"static_test", "--end nothing", 2, "--end: there is no formulation 'nothing'"},
        {"stencil", "--formulation fem", 2, "there is no formulation 'fem'"},
        {"constants", "--volumes all", 2, "choose one of equal, partition"},
        {"constants", "--kernel cubic", 2, "choose one of all, gaussian"},
        {"constants", "--formulation fem", 2, "there is no formulation 'fem'"},
        {"roundoff", "--formulation original", 2, "choose one of order 1 or 2"},
        {"draws", "--formulation fem", 2, "there is no formulation 'fem'"},
        {"plate", "--method weak", 2, "there is no method 'weak'"},
        {"plate", "--method fpm --degree 3", 2, "--degree belongs to methods with an SSPH basis"},
        {"plate", "--method strong --smoothing 1.3", 2, "--smoothing belongs to fpm"},
        {"hole", "--method fpm --smoothing -1", 2, "--smoothing must be positive and finite, got -1"},
        {"plate", "--method fpm --smoothing 0.5", 1, "try --smoothing"},
        {"plate", "--plane bent", 2, "choose one of stress, strain"},
        {"plate", "--corner-1 u1,u9", 2, "there is no condition 'u9'"},
        {"hole", "--states nowhere", 2, "is no pair"},
        {"hole", "--layout ring", 2, "choose graded-N-A, polar-AxR, or a file"},
        {"choices", "--output /nowhere/choices.csv", 1, "cannot write /nowhere/choices.csv: No such file"},
        {"claims", "--paper nobody1999", 2, "there is no paper 'nobody1999'"},
        {"claims", "--count /nowhere.csv", 1, "cannot read /nowhere.csv: No such file"},
        {"walkthrough", "extra", 2, "'extra' was not expected"},
        {"compare_tables", "", 2, "committed"},
        {"compare_tables", "'' ''", 2, "is empty"},
        {"compare_tables", "/nowhere.csv /nowhere.csv", 1, "cannot read /nowhere.csv"},
        {"compare_tables", "/dev/null /dev/null", 1, "/dev/null: the table has no row of column names"},
    });
}

TEST_CASE("bad input: expressions that are none, that are not smooth, or that explode") {
    check({
        {"derivative_test", "--function ''", 2, "--function is empty"},
        {"derivative_test", "--function nan", 2, "there is no 'nan'"},
        {"derivative_test", "--function 1e400", 2, "a number is too long at character 1"},
        {"derivative_test", "--function '9^9^9^9'", 2, "the power is too large at character 4"},
        {"derivative_test", "--function 'exp(exp(exp(9)))'", 2, "exp is too large at character 5"},
        {"derivative_test", "--function 'x^x^x^x'", 2, "is not real and bounded"},
        {"derivative_test", "--function '1/x'", 2, "is not real and bounded near x = 0"},
        {"derivative_test", "--function \"$(printf '%0900d' 0 | tr 0 '(')\"", 2, "nested more than 50 deep"},
        {"derivative_test", "--function \"$(printf '%0900d' 0 | tr 0 -)x\"", 2, "nested more than 50 deep"},
        {"derivative_test", "--function \"$(yes x+ | head -n 9000 | tr -d '\\n')x\"", 2,
         "characters are too many"},
        {"derivative_test", "--function \"$(printf 'x\\nx')\"", 2, "'x?x'"},
        {"static_test", "--displacement 'log(x)'", 2, "is not real and bounded near x = 0"},
        {"static_test", "--displacement '#'", 2, "a number, x, a function or '(' expected at character 1"},
    });
}

TEST_CASE("bad input: files that hold nothing, text, bytes, or particles that make no line or cloud") {
    const Folder folder;
    const auto file = [&](const char* name, const std::string& text) {
        report::write_whole(folder.path + "/" + name, text);
    };
    std::string bytes;
    for (int k = 0; k < 3000; ++k) bytes += static_cast<char>((k * k * 7 + k) % 256);
    file("empty", "");
    file("text", "Whatever this is,\nit is no table.\n");
    file("bytes", bytes);
    file("zeros", std::string(3000, '\0'));
    file("twice", "0\n0.5\n0.5\n1\n");
    file("back", "0\n0.6\n0.5\n1\n");
    file("left", "-1\n0\n1\n");
    file("right", "0\n1\n2\n");
    file("close", "0\n5e-324\n1\n");
    file("outside", "0 0\n1 1\n");
    file("ragged", "a,b\n1,2,3\n");
    file("tolerance", "# tolerance of a: relative\na\n1\n");
    file("stranger", "# tolerance of b: relative 1, absolute 1\na\n1\n");
    struct BadFile {
        const char *command, *name;
        int code;
        const char* reason;
    };
    for (const auto& [command, name, code, reason] : std::vector<BadFile>{
             {"derivative_test --positions ", "empty", 2, "holds no position"},
             {"derivative_test --positions ", "text", 2, "line 2: 'it' is no number"},
             {"derivative_test --positions ", "bytes", 2, "is no number"},
             {"derivative_test --positions ", "zeros", 2, "is no number"},
             {"derivative_test --positions ", "twice", 2, "line 3: '0.5' coincides with the position before"},
             {"static_test --positions ", "back", 2, "sort them"},
             {"static_test --positions ", "left", 2, "is the first position; it must be 0"},
             {"static_test --positions ", "right", 2, "lies beyond 1; scale the positions"},
             {"static_test --formulation modified_fpm --positions ", "close", 1,
              "the local system is singular"},
             {"vibration_test --formulation modified_fpm --positions ", "close", 1,
              "the local system is singular"},
             {"vibration_test --positions ", "", 2, "Is a directory"},
             {"stencil --formulation fpm --positions ", "nothing", 2, "No such file or directory"},
             {"hole --layout ", "empty", 2, " has no particle; at least two are needed"},
             {"hole --layout ", "text", 2, "line 2: 'it is no table.' has 4 columns; a layout needs x,y"},
             {"hole --layout ", "bytes", 2, "bytes, line "},
             {"hole --layout ", "outside", 2, "particle 0 at (0, 0) lies outside the body"},
             {"compare_tables /dev/null ", "empty", 1, "/dev/null: the table has no row of column names"},
             {"claims --count ", "bytes", 1, ""},
             {"claims --count ", "text", 1, "text: line 2 has 1 entries for 2 columns"},
             {"claims --count ", "ragged", 1, "line 2 has 3 entries for 2 columns"},
             {"claims --count ", "tolerance", 1, "tolerance: 'tolerance of a: relative' is no tolerance"},
             {"claims --count ", "stranger", 1, "the table has no column 'b'"},
         })
        check_refused(command + folder.path + "/" + name, code, reason);
    check_refused("derivative_test --positions /dev/zero", 2, "the device gives more than a megabyte");
    check_refused("derivative_test --positions ''", 2, "--positions is empty");
    check_refused("claims --count data/asprone2010/claims.csv " + folder.path + "/text", 1, "line 2 has");
}

TEST_CASE("bad input: what cannot be written is refused before it is computed, and what was there stays") {
    const Folder folder;
    const std::string kept = folder.path + "/kept.csv", folder_itself = folder.path;
    report::write_whole(kept, "kept");
    const std::string draw = "derivative_test --formulation fpm --particles 40";
    check_refused(draw + " --output " + folder_itself, 1, "Is a directory");
    check_refused(draw + " --output " + folder_itself + "/none/x.csv", 1, "No such file or directory");
    check_refused(draw + " --output " + kept + "/x.csv", 1, "Not a directory");
    check_refused(draw + " --output ''", 2, "--output is empty");
    check_refused(draw + " --output /dev/full", 1, "cannot write /dev/full: No space left on device");
    check_refused("derivative_test --formulation fpm --particles 1 --output " + kept, 2,
                  "at least 2 particles");
    check_refused(draw + " --output " + kept + " --smoothing 0.01", 1, "try --smoothing");
    check_refused(draw + " --output " + kept + " --plot " + folder_itself + "/none/x.svg", 1, "No such file");
    check_refused(draw + " --output " + kept + " --plot " + folder_itself, 2, "does not end in .svg");
    check_refused(draw + " --plot ''", 2, "--plot is empty");
    check_refused("orders --output " + folder_itself + "/none/x.csv", 1,
                  "No such file");  // not after minutes
    check_refused("plate --field " + folder_itself + "/none/x.csv", 1, "No such file");
    check_refused("hole --field " + folder_itself, 1, "Is a directory");
    CHECK(report::read_whole(kept) == "kept");
    CHECK(folder.entries() == 1);
}

TEST_CASE("bad input: two outputs in the same file, or an output in the place of an input") {
    const Folder folder;
    const std::string file = folder.path + "/a.svg", again = folder.path + "/./a.svg";
    const std::string line = "0\n0.2\n0.4\n0.6\n0.8\n1\n";
    check_refused("derivative_test --particles 20 --output " + file + " --plot " + again, 2,
                  "--plot and --output name the same file");
    check_refused("plate --method strong --output " + file + " --field " + again, 2,
                  "--field and --output name the same file");
    check_refused("derivative_test --particles 20 --output nowhere.svg --plot ./nowhere.svg", 2,
                  "--plot and --output name the same file");
    check_refused("plate --method strong --field -", 2,
                  "--field and --output both go to the standard output");
    CHECK(folder.entries() == 0);
    report::write_whole(file, line);
    check_refused("derivative_test --formulation fpm --positions " + file + " --plot " + again, 2,
                  "--positions and --plot name the same file");
    check_refused("hole --layout " + file + " --field " + again, 2,
                  "--field and --layout name the same file");
    check_refused("derivative_test --formulation fpm --positions " + file + " --output " + again, 2,
                  "--positions and --output name the same file");
    check_refused("hole --layout " + file + " --output " + again, 2,
                  "--output and --layout name the same file");
    CHECK(report::read_whole(file) == line);
    CHECK(run("derivative_test --particles 20 --output /dev/null --plot " + file).code == 0);
}

TEST_CASE("bad input: an open file that is named as output keeps what stands before and behind") {
    const Folder folder;
    const std::string draw = "derivative_test --formulation fpm --particles 20";
    const std::string table = run(draw).output;
    CHECK(run("{ echo first; " + draw + " --output /dev/stdout; echo last; }").output ==
          "first\n" + table + "last\n");
    CHECK(run("{ " + draw + " --output /dev/stdout | cat; }").output == table);
    CHECK(run("{ " + draw + " --output /dev/fd/3 3>&1; }").output == table);
    check_refused(draw + " --output /dev/fd/7", 1, "cannot write /dev/fd/7: Bad file descriptor");
}

TEST_CASE("bad input: an environment that asks for too much, or for another terminal") {
    const Folder folder;
    const std::string draw = "derivative_test --formulation fpm --particles 20";
    const auto many = run("OMP_NUM_THREADS=100000 " + draw);
    CHECK(many.code == 0);
    CHECK(many.output == run(draw).output);
    CHECK(run("GNUTERM=none " + draw + ",40 --plot " + folder.path + "/a.svg").code == 0);
    CHECK(folder.entries() == 1);
}

// The sanitizer of threads keeps larger files of its own than the limit lets it.
TEST_CASE("bad input: an output that is larger than the shell allows is an error, not a signal" *
          doctest::skip(support::threads_are_watched)) {
    const Folder folder;
    check_refused("derivative_test --formulation fpm --particles 20 --output " + folder.path + "/a.csv", 1,
                  "File too large", "ulimit -f 1; ");
    CHECK(folder.entries() == 0);
}

TEST_CASE("bad input: a file without permission to write is not replaced, nor a folder written into") {
    using std::filesystem::permissions, std::filesystem::perms;
    const Folder folder, programs;
    const std::string kept = folder.path + "/kept.csv";
    report::write_whole(kept, "kept");
    std::string as_anybody;
    if (geteuid() == 0) {  // who may write everywhere; what make coverage counts goes where anybody may write
        std::filesystem::copy(programs::bin() + "/derivative_test", programs.path);
        permissions(programs.path, perms::all);
        as_anybody = "GCOV_PREFIX=" + programs.path + " setpriv --reuid=65534 --regid=65534 --clear-groups " +
                     programs.path + "/";
    }
    const std::string draw = "derivative_test --formulation fpm --particles 40 --output ";
    permissions(folder.path, perms::all);
    permissions(kept, perms::owner_read | perms::others_read);
    check_refused(draw + kept, 1, "cannot write " + kept + ": Permission denied", as_anybody);
    permissions(folder.path, perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec);
    check_refused(draw + folder.path + "/new.csv", 1, "Permission denied", as_anybody);
    permissions(folder.path, perms::owner_all);
    CHECK(report::read_whole(kept) == "kept");
    CHECK(folder.entries() == 1);
}

TEST_CASE("bad input: an output that nobody takes") {
    const std::string draw = "derivative_test --formulation fpm --particles 40";
    // The redirection within goes before the one of run().
    const auto full = [](const std::string& command) {
        const auto [code, output, errors] = run("{ " + command + " >/dev/full; }");
        CAPTURE(command);
        CHECK(code == 1);
        CHECK(errors.find(": cannot write to the standard output") != std::string::npos);
        CHECK(std::count(errors.begin(), errors.end(), '\n') == 1);
    };
    full(draw);
    full("plate --help");
    const Folder folder;
    report::write_whole(folder.path + "/x.csv", "a\n1\n");
    full("compare_tables " + folder.path + "/x.csv " + folder.path + "/x.csv");
    // As every filter does: silence where the pipe is closed, one line where its signal is ignored.
    const auto closed = run("{ { sleep 0.3; " + draw + "; echo $? >&2; } | true; }");
    CHECK(closed.errors == std::to_string(128 + SIGPIPE) + "\n");
    const auto ignored = run("{ trap '' PIPE; { sleep 0.3; " + draw + "; echo $? >&2; } | true; }");
    CHECK(ignored.errors == "derivative_test: cannot write to the standard output: Broken pipe\n1\n");
}

TEST_CASE("bad input: extreme but meaningful numbers give finite tables") {
    for (const char* command :
         {"derivative_test --particles 40 --smoothing 1e3", "derivative_test --particles 40 --perturb 1e-300",
          "derivative_test --particles 40 --function 1e300",
          "static_test --particles 40 --displacement 1e-300",
          "static_test --formulation original --particles 2",
          "constants --formulation fpm --smoothing 1e-300,1",
          "constants_in_space --dimension 2 --formulation ssph --smoothing 1e-300,1",
          "orders --from 1 --to 1 --step 1e300 --seeds 1", "draws --particles 40 --seeds 2 --perturb 0",
          "plate --method strong --scaling 1e18", "plate --method weak2 --gauss 4 --penalty 1e18"})
        check_finite(command);
}

// A program linked for this test (tests/refusals) calls its own main with each option and value, and writes
// one line per invocation.
TEST_CASE("bad input: whatever is given to any option of any program is refused in one line, or computed") {
    std::vector<std::string> all;
    for (const auto& program : std::filesystem::directory_iterator(programs::bin() + "/refusals"))
        all.push_back(program.path());
    CHECK(!all.empty());
    long tried = 0;
#pragma omp parallel for schedule(dynamic) reduction(+ : tried)
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto tries = run(all[k]);
        tried += std::count(tries.output.begin(), tries.output.end(), '\n');
        const std::string last = tries.output.substr(tries.output.rfind('\n', tries.output.size() - 2) + 1);
#pragma omp critical
        if (tries.code != 0 || !tries.errors.empty())
            FAIL_CHECK(tries.errors, "exit code ", tries.code, " after ", last);
    }
    MESSAGE(tried, " invocations of ", all.size(), " programs");
}
