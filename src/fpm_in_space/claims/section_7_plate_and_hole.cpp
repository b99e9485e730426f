#include "fpm_in_space/section_7_plate_and_hole.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "fpm_in_space/claims/ledger.hpp"
#include "fpm_in_space/claims/measures.hpp"
#include "report/statistics.hpp"

namespace fpm_in_space::claims {

namespace {

/// A method as the tables name it. \param degree that of SSPH, empty for FPM
struct MethodInTables {
    std::string method, degree;
};
const MethodInTables quadratic_ssph{"strong", "2"}, cubic_ssph{"strong", "3"}, fpm{"fpm", ""};

/// What a column of a table holds of a method. \param key of a row \throws as DataTable::refuse_without()
template <class Key>
auto column_of(const DataTable& of, const MethodInTables& method, const std::string& column, const Key& key) {
    std::map<decltype(key(of, std::size_t{})), double> found;
    for (std::size_t row = 0; row < of.table.rows.size(); ++row)
        if (of.table.word(row, "method") == method.method && of.table.word(row, "degree") == method.degree)
            found[key(of, row)] = of.number(row, column);
    if (found.empty()) of.refuse_without("rows of " + method.method + " " + method.degree);
    return found;
}

/// log10 of the errors on the plate by the number of particles.
std::map<double, double> errors_on_plate(const MethodInTables& method) {
    return column_of(DataTable("plate"), method, "log_error_nd",
                     [](const DataTable& of, std::size_t row) { return of.number(row, "particles"); });
}

double largest_error_of_cubic_ssph() {
    double largest = -std::numeric_limits<double>::infinity();
    for (const auto& [particles, error] : errors_on_plate(cubic_ssph)) largest = std::max(largest, error);
    return largest;
}

/// How much log10 of the error of SSPH exceeds that of FPM: on the grid where it is least.
double least_gain_on_plate() {
    const auto of_ssph = errors_on_plate(quadratic_ssph);
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [particles, error] : errors_on_plate(fpm))
        least = std::min(least, of_ssph.at(particles) - error);
    return least;
}

/// A number of each layout around the hole: of its name and draw.
using OfLayouts = std::map<std::pair<std::string, std::string>, double>;

/// A column of the solutions of both methods on the layouts with 188 particles, or on the finer ones.
OfLayouts on_layouts(const MethodInTables& method, const std::string& column, bool coarse) {
    const DataTable table(!coarse ? "hole" : method.method == "fpm" ? "hole_fpm_coarse" : "layouts");
    return column_of(table, method, column, [](const DataTable& of, std::size_t row) {
        return std::pair(of.table.word(row, "layout"), of.table.word(row, "draw"));
    });
}

/// Median error of the stress concentration, which is 3. \param layout without its draw
double median_error(const MethodInTables& method, const std::string& layout, bool coarse) {
    std::vector<double> errors;
    for (const auto& [name, concentration] : on_layouts(method, "stress_concentration", coarse))
        if (name.first == layout) errors.push_back(std::abs(concentration - 3));
    return report::quartiles(errors).median;
}

double ratio_of_medians(const std::string& layout, bool coarse) {
    return median_error(fpm, layout, coarse) / median_error(quadratic_ssph, layout, coarse);
}

/// Of the ratio of the quality numbers with the ratio of the errors, FPM over SSPH, on all layouts.
double correlation_of_quality() {
    std::vector<double> quality, error;
    for (const bool coarse : {true, false}) {
        const auto R = on_layouts(fpm, "quality", coarse),
                   R_ssph = on_layouts(quadratic_ssph, "quality", coarse),
                   log_error = on_layouts(fpm, "log_error_nd", coarse),
                   log_error_ssph = on_layouts(quadratic_ssph, "log_error_nd", coarse);
        for (const auto& [layout, R_fpm] : R) {
            quality.push_back(R_fpm / R_ssph.at(layout));
            error.push_back(log_error.at(layout) - log_error_ssph.at(layout));
        }
    }
    return rank_correlation(quality, error);
}

}  // namespace

report::Computations section_7() {
    return {
        // The plate, whose displacement is cubic
        {"F-7-cubic", measured_once(largest_error_of_cubic_ssph)},
        {"F-7-plate", measured_once(least_gain_on_plate)},
        // The hole: coarse, fine, and whether R tells before solving
        {"F-7-coarse", measured_once([] { return ratio_of_medians("graded-188-11", true); })},
        {"F-7-fine", measured_once([] { return ratio_of_medians("graded-2600-41", false); })},
        {"F-7-quality", measured_once(correlation_of_quality)},
    };
}

}  // namespace fpm_in_space::claims
