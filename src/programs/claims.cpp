#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "asprone2010/claims/ledger.hpp"
#include "batra2008/claims/ledger.hpp"
#include "command_line/command_line.hpp"
#include "command_line/progress.hpp"
#include "fpm_in_space/claims/ledger.hpp"
#include "report/file.hpp"
#include "report/ledger.hpp"
#include "report/papers.hpp"
#include "report/read_table.hpp"
#include "report/tally.hpp"

namespace {

using report::Table;

/// A paper's computations. \throws base::FailedComputation where it has none
report::Computations computations_of(const report::Paper& paper) {
    for (const report::Ledger& ledger :
         {asprone2010::claims::ledger(), batra2008::claims::ledger(), fpm_in_space::claims::ledger()})
        if (ledger.paper == paper.folder) return ledger.computations;
    throw base::FailedComputation(paper.folder + " has no computations that decide claims");
}

/// The verdicts on a paper's claims. \param file the list of all claims, paper/claims.csv
Table verdicts(const std::string& folder, const std::string& file) {
    const auto papers = report::papers(report::parsed_words(report::read_whole("paper/papers.csv")));
    const report::Paper& paper = report::paper_named(folder, papers);
    const Table claims = report::by_paper(report::read_table(file), papers).at(folder);
    command_line::Progress progress(claims.rows.size());
    return report::judged(claims, paper, computations_of(paper), [&] { progress.step(); });
}

/// A line for each table of verdicts; of several tables, each line names the paper, whose folder holds the
/// table.
std::string counts(const std::vector<std::string>& files) {
    std::string lines;
    for (const std::string& file : files) {
        const std::string paper = std::filesystem::absolute(file).parent_path().filename().string();
        lines += (files.size() > 1 ? paper + ": " : "") +
                 report::in_full(report::tally(report::read_table(file))) + "\n";
    }
    return lines;
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Decides every claim of a paper by its computation, under both conventions that the print leaves open. It runs in the top folder.",
        "claims", "Example: claims --paper asprone2010 --output /tmp/claims.csv");
    std::string paper = "asprone2010", claims = "paper/claims.csv", output;
    std::vector<std::string> decided;
    app.add_option("--paper", paper, "whose claims (default asprone2010)").type_name("PAPER");
    app.add_option("--ledger", claims, "CSV file with a row for each claim (default paper/claims.csv)")
        .type_name("FILE");
    app.add_output(output);
    app.add_option("--count", decided,
                   "count the verdicts in these CSV files, data/PAPER/claims.csv, and compute nothing")
        .type_name("FILE");
    return command_line::run(app, argc, argv, [&] {
        if (!decided.empty()) {
            std::cout << counts(decided);
            return 0;
        }
        report::check_writable(output);
        report::write_whole(output, report::csv(verdicts(paper, claims)));
        return 0;
    });
}
