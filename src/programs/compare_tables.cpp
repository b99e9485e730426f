#include <iostream>
#include <string>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "command_line/command_line.hpp"
#include "report/read_table.hpp"

int main(int argc, char** argv) {
    command_line::CommandLine app(
        "Compares a regenerated table with the committed one, within the tolerances that the latter states.",
        "compare_tables", "Example: compare_tables data/asprone2010/figure_1.csv /tmp/figure_1.csv");
    std::string committed, regenerated;
    app.add_option("committed", committed, "CSV file that states its tolerances").required();
    app.add_option("regenerated", regenerated, "CSV file to compare").required();
    return command_line::run(app, argc, argv, [&] {
        const auto expected = report::read_table(committed);
        const auto computed = report::read_table(regenerated);
        const auto found = report::differences(expected, computed);
        for (const std::string& difference : found) std::cout << committed << ": " << difference << "\n";
        std::cout << committed << ": " << expected.rows.size() << " rows, ";
        if (!found.empty()) {
            std::cout << found.size() << " differences\n";
            return 1;
        }
        const report::Move most = report::largest_move(expected, computed);
        std::cout << "all within tolerance; ";
        if (most.by == 0)
            std::cout << "no number moved\n";
        else
            std::cout << "largest change in row " << most.row + 1 << ", " << most.column << ", by "
                      << base::shown(most.by, 2) << ", " << base::shown(100 * most.share, 2)
                      << " % of its tolerance\n";
        return 0;
    });
}
