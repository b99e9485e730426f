#include "asprone2010/claims.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "programs/options.hpp"
#include "programs/progress.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

namespace {

/// The ledger with its verdicts. \throws FailedComputation for a claim without a computation, or the reverse
report::Table judged(const report::Table& ledger) {
    using particles::FailedComputation;
    const auto& computations = asprone2010::claims::computations();
    report::Table table;
    table.comments = {
        "Asprone et al. (2010): every testable statement, what was measured under both conventions of the "
        "volumes, and "
        "the verdict that follows",
        "conditional: what a reading that adds a condition gives, volumes equal, where the claim as it "
        "stands fails"};
    table.columns = {{"id"},
                     {"section"},
                     {"claim"},
                     {"quantity"},
                     {"statement"},
                     {"measured_equal", {1e-3, 1e-9}},
                     {"measured_partition", {1e-3, 1e-9}},
                     {"conditional", {1e-3, 1e-9}},
                     {"verdict"}};
    programs::Progress progress(ledger.rows.size(), std::cerr, isatty(STDERR_FILENO) != 0);
    for (std::size_t row = 0; row < ledger.rows.size(); ++row) {
        const std::string id = ledger.word(row, "id");
        const auto computation = computations.find(id);
        if (computation == computations.end())
            throw FailedComputation("claim " + id + " has no computation that decides it");
        const auto number = [&](const char* name) {
            return std::get<double>(ledger.rows[row][ledger.column(name)]);
        };
        const report::Statement statement{ledger.word(row, "relation"), number("expected"),
                                          number("tolerance")};
        const auto equal = computation->second(particles::Volumes::equal);
        const auto partition = computation->second(particles::Volumes::partition);
        const std::string verdict = report::verdict(statement, equal, partition);
        const auto cell = [](const std::vector<report::Measurement>& measured, std::size_t k) {
            return k < measured.size() && std::isfinite(measured[k].value) ? report::Cell(measured[k].value)
                                                                           : report::Cell();
        };
        const std::string tolerance =
            statement.tolerance > 0 ? " ± " + particles::shown(statement.tolerance) : std::string();
        table.rows.push_back({id, ledger.word(row, "section"), ledger.word(row, "claim"),
                              ledger.word(row, "quantity"),
                              statement.relation + " " + particles::shown(statement.expected) + tolerance,
                              cell(equal, 0), cell(partition, 0), cell(equal, 1), verdict});
        progress.step();
    }
    if (computations.size() != ledger.rows.size())
        throw FailedComputation(std::to_string(computations.size()) + " computations decide " +
                                std::to_string(ledger.rows.size()) +
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
    CLI::App app("Decides every claim of a ledger by its computation, under both conventions of the volumes.",
                 "claims");
    app.footer("Example: claims --ledger paper/claims.csv --output /tmp/claims.csv");
    std::string ledger = "paper/claims.csv", output, decided;
    app.add_option("--ledger", ledger, "CSV file with a row for each claim (default paper/claims.csv)")
        ->type_name("FILE");
    app.add_option("--output", output, "CSV file to write (default: standard output)")->type_name("FILE");
    app.add_option("--count", decided,
                   "CSV file of verdicts: say how many there are of each kind, and compute nothing")
        ->type_name("FILE");
    return programs::run(app, argc, argv, [&] {
        if (!decided.empty()) {
            std::cout << summary(report::parsed(report::read_whole(decided))) << "\n";
            return 0;
        }
        const report::Table table = judged(report::parsed(report::read_whole(ledger)));
        report::write_whole(output, report::csv(table));
        return 0;
    });
}
