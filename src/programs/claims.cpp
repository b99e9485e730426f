#include "asprone2010/claims.hpp"
#include "base/text.hpp"
#include "batra2008/claims.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include "command_line/command_line.hpp"
#include "command_line/progress.hpp"
#include "report/file.hpp"
#include "report/papers.hpp"
#include "report/read_table.hpp"
#include "report/table.hpp"

namespace {

using base::FailedComputation;
using report::Ledger;
using report::Paper;

/// The ledgers of all papers, a line each.
std::vector<Ledger> ledgers() {
    return {
        asprone2010::claims::ledger(),
        batra2008::claims::ledger(),
    };
}

/// A paper's ledger. \throws FailedComputation where there is none
Ledger ledger_of(const Paper& paper) {
    for (const Ledger& ledger : ledgers())
        if (ledger.paper == paper.folder) return ledger;
    throw FailedComputation(paper.folder + " has no computations that decide claims");
}

/// A paper's claims with their verdicts. \throws FailedComputation for a claim without a computation, or the reverse
report::Table judged(const report::Table& claims, const Paper& paper) {
    const auto computations = ledger_of(paper).computations;
    const auto& [about, one, other] = paper.conventions;
    report::Table table;
    table.comments = {paper.citation +
                          ": every testable statement, what was measured under both conventions of the " +
                          about + ", and the verdict that follows",
                      "conditional: what a reading that adds a condition gives, " + about + " " + one.name +
                          ", where the claim as it stands fails"};
    table.columns = {{"id"},
                     {"section"},
                     {"claim"},
                     {"quantity"},
                     {"statement"},
                     {"measured_" + one.name, {1e-3, 1e-9}},
                     {"measured_" + other.name, {1e-3, 1e-9}},
                     {"conditional", {1e-3, 1e-9}},
                     {"verdict"}};
    command_line::Progress progress(claims.rows.size());
    for (std::size_t row = 0; row < claims.rows.size(); ++row) {
        const std::string id = claims.word(row, "id");
        const auto computation = computations.find(id);
        if (computation == computations.end())
            throw FailedComputation("claim " + id + " has no computation that decides it");
        const auto number = [&](const char* name) {
            return std::get<double>(claims.rows[row][claims.column(name)]);
        };
        const report::Statement statement{claims.word(row, "relation"), number("expected"),
                                          number("tolerance")};
        const auto with_one = computation->second(0), with_other = computation->second(1);
        const std::string verdict = report::verdict(statement, paper.conventions, with_one, with_other);
        const auto cell = [](const std::vector<report::Measurement>& measured, std::size_t k) {
            return k < measured.size() && std::isfinite(measured[k].value) ? report::Cell(measured[k].value)
                                                                           : report::Cell();
        };
        const std::string tolerance =
            statement.tolerance > 0 ? " ± " + base::shown(statement.tolerance) : std::string();
        table.rows.push_back({id, claims.word(row, "section"), claims.word(row, "claim"),
                              claims.word(row, "quantity"),
                              statement.relation + " " + base::shown(statement.expected) + tolerance,
                              cell(with_one, 0), cell(with_other, 0), cell(with_one, 1), verdict});
        progress.step();
    }
    if (computations.size() != claims.rows.size())
        throw FailedComputation(std::to_string(computations.size()) + " computations decide " +
                                std::to_string(claims.rows.size()) +
                                " claims; every computation needs its row");
    return table;
}

/// "74 claims: 66 reproduced, 3 hold under a condition, 5 differ, 0 cannot tell"
std::string summary(const report::Table& table) {
    int reproduced = 0, conditional = 0, differ = 0, undecided = 0;
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
        const std::string verdict = table.word(row, "verdict");
        ++(verdict == "reproduced"    ? reproduced
           : verdict == "differs"     ? differ
           : verdict == "cannot tell" ? undecided
                                      : conditional);
    }
    return std::to_string(table.rows.size()) + " claims: " + std::to_string(reproduced) + " reproduced, " +
           std::to_string(conditional) + " hold under a condition, " + std::to_string(differ) + " differ, " +
           std::to_string(undecided) + " cannot tell";
}

}  // namespace

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Decides every claim of a paper by its computation, under both conventions that the print leaves "
        "open. It runs in the top folder.",
        "claims", "Example: claims --paper asprone2010 --output /tmp/claims.csv");
    std::string folder = "asprone2010", ledger = "paper/claims.csv", output;
    std::vector<std::string> decided;
    app.add_option("--paper", folder, "whose claims (default asprone2010)").type_name("PAPER");
    app.add_option("--ledger", ledger, "CSV file with a row for each claim (default paper/claims.csv)")
        .type_name("FILE");
    app.add_output(output);
    app.add_option("--count", decided,
                   "CSV files of verdicts, data/PAPER/claims.csv: say how many there are of each kind, and "
                   "compute nothing")
        .type_name("FILE");
    return command_line::run(app, argc, argv, [&] {
        std::string counts;
        for (const std::string& file : decided) {
            const std::string paper = std::filesystem::absolute(file).parent_path().filename().string();
            counts += (decided.size() > 1 ? paper + ": " : "") + summary(report::read_table(file)) + "\n";
        }
        std::cout << counts;
        if (!decided.empty()) return 0;
        report::check_writable(output);
        const auto papers = report::papers(report::parsed_words(report::read_whole("paper/papers.csv")));
        const Paper& paper = report::paper_named(folder, papers);
        const auto claims = report::by_paper(report::read_table(ledger), papers);
        report::write_whole(output, report::csv(judged(claims.at(folder), paper)));
        return 0;
    });
}
