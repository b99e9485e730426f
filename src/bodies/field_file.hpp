#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "bodies/body.hpp"

namespace bodies {

/// Numbers at the particles.
struct NamedField {
    std::string name;
    Eigen::MatrixXd values;  ///< a column for each particle, a row for each component
};

/// \throws base::InvalidInput unless the file's name ends with .vtu or .csv
void check_field_path(const std::string& path);

/// Writes fields at the particles of a body: a name that ends with .vtu makes an unstructured grid for
/// ParaView, of the body's cells or, without any, of its particles; one that ends with .csv a table. The file
/// appears as a whole or not at all, and the same fields give the same bytes.
/// \param comments lines that begin a table; a grid has none
/// \throws base::InvalidInput as check_field_path(); base::FailedComputation for a number that is not finite
///         with the field and the place, for a field of another length, and for a file that cannot be written
template <int dim>
void write_field(const std::string& path, const Body<dim>& body, const std::vector<NamedField>& fields,
                 const std::vector<std::string>& comments = {});

}  // namespace bodies
