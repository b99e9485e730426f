#include "command_line/body_table.hpp"

namespace command_line {

template <int dim>
std::vector<report::ColumnHead> columns() {
    std::vector<report::ColumnHead> all{{"method"}, {"particles"}, {"quantity"}, {"x"}, {"y"}};
    if (dim == 3) all.push_back({"z"});
    all.push_back({"value", {1e-6, 0}});
    return all;
}

template <int dim>
std::vector<report::Cell> row(const std::string& method, bodies::Index particles,
                              const Quantity<dim>& quantity) {
    std::vector<report::Cell> cells{method, static_cast<long>(particles), quantity.name};
    for (int axis = 0; axis < dim; ++axis)
        if (quantity.place)
            cells.emplace_back((*quantity.place)[axis]);
        else
            cells.emplace_back();
    cells.emplace_back(quantity.value);
    return cells;
}

template <int dim, int n>
std::vector<std::string> about_sides(const bodies::Problem<dim, n>& problem, const bodies::Body<dim>& body,
                                     const std::vector<bodies::Index>& counts) {
    std::string sides, free;
    for (std::size_t k = 0; k < counts.size(); ++k) {
        const auto& side = body.sides[k];
        const std::string name = bodies::is_unnamed(side.name) ? "the rest of the boundary" : side.name;
        sides += (sides.empty() ? "" : ", ") + name + " (" + std::to_string(counts[k]) + ")";
        if (problem.given_on(side) == nullptr) free += (free.empty() ? "" : ", ") + name;
    }
    const std::string what = n == 1 ? "insulated" : "free of loads";
    return {"sides, with their particles: " + sides,
            what + ", since nothing is given there: " + (free.empty() ? "none" : free)};
}

std::string about_numbers(bool is_scalar, int dim, bool are_eigenvalues) {
    if (are_eigenvalues)
        return is_scalar
                   ? "eigenvalues of -div(k grad u) + c u = lambda u, all values and loads zero"
                   : "eigenvalues of -div(stress) + c u = lambda u, all values and loads zero: with a density rho the frequency is sqrt(lambda/rho)/(2 pi)";
    if (is_scalar)
        return std::string(dim == 2 ? "q1, q2" : "q1, q2, q3") +
               ": the flux of heat -k grad u; loads and reactions are heat that enters";
    return dim == 2 ? "loads and reactions are per unit thickness" : "";
}

template std::vector<report::ColumnHead> columns<2>();
template std::vector<report::ColumnHead> columns<3>();
template std::vector<report::Cell> row(const std::string&, bodies::Index, const Quantity<2>&);
template std::vector<report::Cell> row(const std::string&, bodies::Index, const Quantity<3>&);
template std::vector<std::string> about_sides(const bodies::Problem<2, 1>&, const bodies::Body<2>&,
                                              const std::vector<bodies::Index>&);
template std::vector<std::string> about_sides(const bodies::Problem<3, 1>&, const bodies::Body<3>&,
                                              const std::vector<bodies::Index>&);
template std::vector<std::string> about_sides(const bodies::Problem<2, 2>&, const bodies::Body<2>&,
                                              const std::vector<bodies::Index>&);
template std::vector<std::string> about_sides(const bodies::Problem<3, 3>&, const bodies::Body<3>&,
                                              const std::vector<bodies::Index>&);

}  // namespace command_line
