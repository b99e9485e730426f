#include "command_line/field_file.hpp"

#include <utility>

#include "base/errors.hpp"
#include "base/text.hpp"
#include "command_line/states.hpp"
#include "report/file.hpp"

namespace command_line {

using namespace batra2008;
using base::InvalidInput;
using report::Cell;

FieldFile::FieldFile(std::string path, const std::vector<ExampleCase>& cases) : path_(std::move(path)) {
    report::check_writable(path_);
    table_.comments = {"displacements u [m] and stresses s [Pa] at the particles x [m], computed and exact"};
    table_.columns = case_columns();
    for (const auto& column : state_columns(cases)) table_.columns.push_back(column);
}

void FieldFile::require_same(const Points<2>& x) {
    if (path_.empty()) return;
    if (x_.cols() == 0) x_ = x;
    if (x.cols() != x_.cols() || x != x_)
        throw InvalidInput("--field holds one set of particles; ask for one at a time");
}

void FieldFile::add(const ExampleCase& one, const Solved& solved) {
    if (path_.empty()) return;
    std::vector<Cell> cells = case_cells(one);
    cells[1] = static_cast<long>(x_.cols());
    const std::vector<Point<2>> places = places_at(x_);
    const std::size_t first = table_.rows.size();
    const auto rows = state_rows(cells, solved, places);
    table_.rows.insert(table_.rows.end(), rows.begin(), rows.end());

    const auto array = [&](const std::string& name, const std::string& kind,
                           const std::vector<const char*>& from, std::size_t zeros) {
        vtk_ += kind == "SCALARS" ? "SCALARS " + name + " double 1\nLOOKUP_TABLE default\n"
                                  : kind + " " + name + " double\n";
        for (std::size_t row = first; row < table_.rows.size(); ++row) {
            for (const char* column : from)
                vtk_ += base::shown(std::get<double>(table_.rows[row][table_.column(column)]), 10) + " ";
            for (std::size_t k = 0; k < zeros; ++k) vtk_ += "0 ";
            vtk_.back() = '\n';
        }
    };
    const auto arrays = [&](const std::string& name, const std::string& suffix) {
        const std::string u1 = "u1" + suffix, u2 = "u2" + suffix;
        array("u_" + name, "VECTORS", {u1.c_str(), u2.c_str()}, 1);
        for (const char* component : {"s11", "s22", "s12"}) {
            const std::string column = component + suffix;
            array(std::string(component) + "_" + name, "SCALARS", {column.c_str()}, 0);
        }
    };
    const auto numbered = [&](const std::string& name) {
        const bool taken = vtk_.find("u_" + name + " ") != std::string::npos;
        return taken ? name + "_" + std::to_string(first / places.size()) : name;
    };
    // The exact states are written again where the material is another one.
    const auto exact = [&](std::size_t row) {
        const std::vector<Cell>& cells_of = table_.rows[row];
        return std::vector<Cell>(cells_of.begin() + static_cast<Index>(table_.column("u1_exact")),
                                 cells_of.end());
    };
    bool another = first == 0;
    for (std::size_t k = 0; !another && k < places.size(); ++k)
        another = exact(first + k) != exact(first - places.size() + k);
    if (another) arrays(numbered("exact"), "_exact");
    arrays(numbered(one.method), "");
}

void FieldFile::write() const {
    if (path_.empty()) return;
    if (!path_.ends_with(".vtk")) {
        report::write_whole(path_, report::csv(table_));
        return;
    }
    const std::string count = std::to_string(x_.cols());
    std::string text = "# vtk DataFile Version 3.0\n" + table_.comments.front() +
                       "\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " + count + " double\n";
    for (Index I = 0; I < x_.cols(); ++I)
        text += base::shown(x_(0, I), 17) + " " + base::shown(x_(1, I), 17) + " 0\n";
    text += "CELLS " + count + " " + std::to_string(2 * x_.cols()) + "\n";  // a vertex for each particle
    for (Index I = 0; I < x_.cols(); ++I) text += "1 " + std::to_string(I) + "\n";
    text += "CELL_TYPES " + count + "\n";
    for (Index I = 0; I < x_.cols(); ++I) text += "1\n";
    report::write_whole(path_, text + "POINT_DATA " + count + "\n" + vtk_);
}

}  // namespace command_line
