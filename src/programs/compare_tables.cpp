#include <iostream>
#include <string>

#include "programs/command_line.hpp"
#include "report/read_table.hpp"

int main(int argc, char** argv) {
    programs::CommandLine app(
        "Compares a regenerated table with the committed one, within the tolerances that the latter states.",
        "compare_tables", "Example: compare_tables data/asprone2010/figure_1.csv /tmp/figure_1.csv");
    std::string committed, regenerated;
    app.add_option("committed", committed, "CSV file that states its tolerances").required();
    app.add_option("regenerated", regenerated, "CSV file to compare").required();
    return programs::run(app, argc, argv, [&] {
        const auto expected = report::read_table(committed);
        const auto found = report::differences(expected, report::read_table(regenerated));
        for (const std::string& difference : found) std::cout << committed << ": " << difference << "\n";
        std::cout << committed << ": " << expected.rows.size() << " rows, "
                  << (found.empty() ? "all within tolerance" : std::to_string(found.size()) + " differences")
                  << "\n";
        return found.empty() ? 0 : 1;
    });
}
