#include <CLI/CLI.hpp>
#include <iostream>

#include "report/file.hpp"
#include "report/table.hpp"

int main(int argc, char** argv) {
    CLI::App app(
        "Compares a regenerated table with the committed one, within the tolerances that the latter states.",
        "compare_tables");
    app.footer("Example: compare_tables data/asprone2010/figure_1.csv /tmp/figure_1.csv");
    std::string committed, regenerated;
    app.add_option("committed", committed, "CSV file that states its tolerances")->required();
    app.add_option("regenerated", regenerated, "CSV file to compare")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        std::cerr << "compare_tables: " << error.what() << "; see compare_tables --help\n";
        return 2;
    }
    try {
        const auto expected = report::parsed(report::read_whole(committed));
        const auto found = report::differences(expected, report::parsed(report::read_whole(regenerated)));
        for (const std::string& difference : found) std::cout << committed << ": " << difference << "\n";
        std::cout << committed << ": " << expected.rows.size() << " rows, "
                  << (found.empty() ? "all within tolerance" : std::to_string(found.size()) + " differences")
                  << "\n";
        return found.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << "compare_tables: " << error.what() << "\n";
        return 1;
    }
}
