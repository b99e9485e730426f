#include "distributed/field_file.hpp"

#include <algorithm>
#include <filesystem>

#include "base/errors.hpp"
#include "report/file.hpp"

namespace distributed {

namespace {

const std::string ending = ".pvtu";

/// An array of the index; vectors of the plane have a third component, as in the pieces.
std::string array(const std::string& name, bodies::Index components) {
    return R"(<PDataArray type="Float64" Name=")" + name + R"(" NumberOfComponents=")" +
           std::to_string(components == 2 ? 3 : components) + "\"/>\n";
}

/// A text as the value of an attribute of XML.
std::string attribute(const std::string& text) {
    std::string safe;
    for (const char letter : text)
        safe += letter == '&'   ? "&amp;"
                : letter == '<' ? "&lt;"
                : letter == '"' ? "&quot;"
                                : std::string(1, letter);
    return safe;
}

}  // namespace

template <int dim>
Drawn<dim>::Drawn(const Part<dim>& part) : particle(part.own) {
    body.cells.assign(part.body.cells.begin(), part.body.cells.begin() + part.own_cells);
    for (const auto& cell : body.cells) particle.insert(particle.end(), cell.begin(), cell.end());
    std::sort(particle.begin(), particle.end());
    particle.erase(std::unique(particle.begin(), particle.end()), particle.end());
    body.x = part.body.x(Eigen::all, particle);
    for (auto& cell : body.cells)
        for (int& I : cell)
            I = static_cast<int>(std::lower_bound(particle.begin(), particle.end(), I) - particle.begin());
}

void check_field_path(const std::string& path) {
    if (!path.ends_with(ending))
        throw base::InvalidInput("--field " + path + ": the name must end with .pvtu");
}

std::string piece_of(const std::string& path, int process) {
    return path.substr(0, path.size() - ending.size()) + "_" + std::to_string(process) + ".vtu";
}

template <int dim>
void write_field(const Processes& processes, const std::string& path, const bodies::Body<dim>& body,
                 const std::vector<bodies::NamedField>& fields) {
    check_field_path(path);
    const bool draws = body.x.cols() > 0;
    processes.together([&] {
        if (draws) bodies::write_field(piece_of(path, processes.rank()), body, fields);
    });
    const std::vector<double> all = processes.gathered({draws ? 1.0 : 0.0});
    processes.together([&] {
        if (!processes.is_first()) return;
        std::string text =
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"PUnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n<PUnstructuredGrid GhostLevel=\"0\">\n<PPoints>\n" +
            array("Points", 3) + "</PPoints>\n<PPointData>\n";
        for (const auto& field : fields) text += array(field.name, field.values.rows());
        text += "</PPointData>\n";
        for (int rank = 0; rank < processes.count(); ++rank)
            if (all[static_cast<std::size_t>(rank)] != 0)
                text += "<Piece Source=\"" +
                        attribute(std::filesystem::path(piece_of(path, rank)).filename().string()) + "\"/>\n";
        report::write_whole(path, text + "</PUnstructuredGrid>\n</VTKFile>\n");
    });
}

template struct Drawn<2>;
template struct Drawn<3>;
template void write_field(const Processes&, const std::string&, const bodies::Body<2>&,
                          const std::vector<bodies::NamedField>&);
template void write_field(const Processes&, const std::string&, const bodies::Body<3>&,
                          const std::vector<bodies::NamedField>&);

}  // namespace distributed
