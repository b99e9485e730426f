#include "command_line/spectrum.hpp"

#include <cmath>
#include <utility>

namespace command_line {

using report::Cell;

namespace {

bool has_no_real_part(const std::complex<double>& frequency) {
    return frequency.real() <= 1e-9 * std::abs(frequency.imag());
}

}  // namespace

std::vector<report::ColumnHead> columns_of_modes() {
    return {{"mode"},
            {"frequency", {1e-8, 1e-8}},
            {"frequency_imaginary", {1e-8, 1e-8}},
            {"exact"},
            {"ratio", {1e-8, 1e-9}}};
}

std::vector<std::vector<Cell>> rows_of_modes(const std::vector<Cell>& named,
                                             const std::vector<std::complex<double>>& frequencies,
                                             const std::function<double(base::Index)>& exact,
                                             const std::function<Cell(base::Index, std::size_t)>& last) {
    std::vector<std::vector<Cell>> all;
    base::Index n = 0;
    for (const std::complex<double>& frequency : frequencies) {
        std::vector<Cell> cells = named;
        if (has_no_real_part(frequency)) {
            cells.insert(cells.end(), {Cell(), frequency.real(), frequency.imag(), Cell(), Cell(), Cell()});
        } else {
            const double exact_n = exact(++n);
            cells.insert(cells.end(), {static_cast<long>(n), frequency.real(), frequency.imag(), exact_n,
                                       frequency.real() / exact_n, last(n, all.size())});
        }
        all.push_back(std::move(cells));
    }
    return all;
}

}  // namespace command_line
