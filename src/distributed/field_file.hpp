#pragma once

#include <string>
#include <vector>

#include "bodies/field_file.hpp"
#include "distributed/part.hpp"
#include "distributed/processes.hpp"

namespace distributed {

/// The particles that a process owns, and the corners of its cells, as a body to be drawn.
template <int dim>
struct Drawn {
    Body<dim> body;
    std::vector<int> particle;  ///< of the part

    explicit Drawn(const Part<dim>& part);
};

/// \throws base::InvalidInput unless the file's name ends with .pvtu
void check_field_path(const std::string& path);

/// The file of a process beside the index: FILE_0.vtu and so on.
std::string piece_of(const std::string& path, int process);

/// Writes fields for ParaView: each process piece_of(), the first one the index, which names them, when all
/// are complete.
/// \param body what this process draws; nothing where it has no particles
/// \param fields at the particles of the body; on each process with the same names
template <int dim>
void write_field(const Processes& processes, const std::string& path, const bodies::Body<dim>& body,
                 const std::vector<bodies::NamedField>& fields);

}  // namespace distributed
