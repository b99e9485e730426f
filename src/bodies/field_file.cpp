#include "bodies/field_file.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/errors.hpp"
#include "report/file.hpp"
#include "report/table.hpp"

namespace bodies {

namespace {

template <int dim>
void check(const Body<dim>& body, const NamedField& field) {
    if (field.values.cols() != body.x.cols())
        throw base::FailedComputation("the field " + field.name + " has " +
                                      std::to_string(field.values.cols()) + " columns for " +
                                      std::to_string(body.x.cols()) + " particles");
    for (Index j = 0; j < body.x.cols(); ++j)
        if (!field.values.col(j).allFinite())
            throw base::FailedComputation("the field " + field.name + " is not finite at " +
                                          particles::shown_point(body.x.col(j)));
}

/// Numbers in the fewest digits that read back exactly, and a line end.
template <class Numbers>
void append(std::string& text, const Numbers& numbers) {
    std::array<char, 32> digits{};
    for (const auto number : numbers) {
        text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
        text += ' ';
    }
    text.back() = '\n';
}

/// An array of the grid, a column of numbers for each tuple; vectors of the plane get a third component, 0.
template <class Numbers>
std::string data_array(const std::string& name, const std::string& type, const Numbers& columns) {
    const bool in_plane = columns.rows() == 2;
    std::string text = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                       std::to_string(in_plane ? 3 : columns.rows()) + "\" format=\"ascii\">\n";
    for (Index j = 0; j < columns.cols(); ++j) {
        append(text, columns.col(j));
        if (in_plane) text.insert(text.size() - 1, " 0");
    }
    return text + "</DataArray>\n";
}

/// VTK's element Cells: the corners of all cells in sequence, where each cell ends, and the cell type.
std::string cells_of(const Eigen::MatrixXi& corners, int kind) {
    const Index count = corners.cols();
    const Eigen::RowVectorXi ends = Eigen::RowVectorXi::LinSpaced(count, 1, static_cast<int>(count)) *
                                    static_cast<int>(corners.rows()),
                             kinds = Eigen::RowVectorXi::Constant(count, kind);
    const Eigen::Map<const Eigen::RowVectorXi> all(corners.data(), corners.size());
    return "<Cells>\n" + data_array("connectivity", "Int32", all) + data_array("offsets", "Int32", ends) +
           data_array("types", "UInt8", kinds) + "</Cells>\n";
}

template <int dim>
std::string cells(const Body<dim>& body) {
    constexpr int vertex = 1, simplex = dim == 2 ? 5 : 10;  // VTK's numbers
    const auto particles = static_cast<int>(body.x.cols()), count = static_cast<int>(body.cells.size());
    if (body.cells.empty())
        return cells_of(Eigen::RowVectorXi::LinSpaced(particles, 0, particles - 1), vertex);
    return cells_of(Eigen::Map<const Eigen::MatrixXi>(body.cells[0].data(), dim + 1, count), simplex);
}

template <int dim>
std::string grid(const Body<dim>& body, const std::vector<NamedField>& fields) {
    const std::size_t count =
        body.cells.empty() ? static_cast<std::size_t>(body.x.cols()) : body.cells.size();
    std::string text =
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"" +
        std::to_string(body.x.cols()) + "\" NumberOfCells=\"" + std::to_string(count) + "\">\n<Points>\n" +
        data_array("Points", "Float64", body.x) + "</Points>\n" + cells(body) + "<PointData>\n";
    for (const NamedField& field : fields) text += data_array(field.name, "Float64", field.values);
    return text + "</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

template <int dim>
report::Table table(const Body<dim>& body, const std::vector<NamedField>& fields,
                    const std::vector<std::string>& comments) {
    report::Table table{comments, {{"x"}, {"y"}}, {}};
    if (dim == 3) table.columns.push_back({"z"});
    for (const NamedField& field : fields)
        for (Index k = 0; k < field.values.rows(); ++k)
            table.columns.push_back({field.name + (field.values.rows() > 1 ? std::to_string(k + 1) : "")});
    for (Index j = 0; j < body.x.cols(); ++j) {
        std::vector<report::Cell> row(body.x.col(j).begin(), body.x.col(j).end());
        for (const NamedField& field : fields)
            row.insert(row.end(), field.values.col(j).begin(), field.values.col(j).end());
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace

void check_field_path(const std::string& path) {
    if (!path.ends_with(".vtu") && !path.ends_with(".csv"))
        throw base::InvalidInput("--field " + path +
                                 ": the name must end with .vtu, for ParaView, or with .csv");
}

template <int dim>
void write_field(const std::string& path, const Body<dim>& body, const std::vector<NamedField>& fields,
                 const std::vector<std::string>& comments) {
    check_field_path(path);
    for (const NamedField& field : fields) check(body, field);
    report::write_whole(
        path, path.ends_with(".vtu") ? grid(body, fields) : report::csv(table(body, fields, comments)));
}

template void write_field(const std::string&, const Body<2>&, const std::vector<NamedField>&,
                          const std::vector<std::string>&);
template void write_field(const std::string&, const Body<3>&, const std::vector<NamedField>&,
                          const std::vector<std::string>&);

}  // namespace bodies
