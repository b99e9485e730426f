#include "meshes/drawing.hpp"

#include <gmsh.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.hpp"
#include "base/text.hpp"

namespace meshes {

using base::InvalidInput;
using base::shown;
using particles::Point;

namespace {

constexpr double most_particles = 5e6;

/// Gmsh's numbers of the ways to mesh that give even cells of the size asked for.
constexpr int frontal_delaunay = 6, delaunay = 1;

/// Corners of the bounding box of all that is drawn.
std::array<Point<3>, 2> bounding_box() {
    std::array<Point<3>, 2> box;
    gmsh::model::getBoundingBox(-1, -1, box[0][0], box[0][1], box[0][2], box[1][0], box[1][1], box[1][2]);
    return box;
}

/// The nodes of a mesh of equilateral triangles, or of the tetrahedra that fill space best.
double count(int dim, double content, double size) {
    return content / std::pow(size, dim) * (dim == 2 ? 2 / std::sqrt(3.0) : std::sqrt(2.0));
}

double box_content(int dim, const Point<3>& extent) {
    return dim == 2 ? extent[0] * extent[1] : extent.prod();
}

void bound_sizes(double size) {
    gmsh::option::setNumber("Mesh.MeshSizeMin", size);
    gmsh::option::setNumber("Mesh.MeshSizeMax", size);
}

/// Area or volume of the cells.
double content(int dim) {
    double sum = 0;
    gmsh::vectorpair all;
    gmsh::model::getEntities(all, dim);
    for (const auto& [same, tag] : all) {
        std::vector<int> types;
        gmsh::model::mesh::getElementTypes(types, dim, tag);
        for (const int type : types) {
            const std::vector<double> corner{0, 0, 0};
            std::vector<double> jacobians, determinants, x;
            gmsh::model::mesh::getJacobians(type, corner, jacobians, determinants, x, tag);
            for (const double determinant : determinants) sum += std::abs(determinant) / (dim == 2 ? 2 : 6);
        }
    }
    return sum;
}

}  // namespace

Drawing::Drawing(int dim) : dim_(dim) {
    for (const auto& [option, value] : {std::pair{"Algorithm", frontal_delaunay},
                                        {"Algorithm3D", delaunay},
                                        {"ElementOrder", 1},
                                        {"RecombineAll", 0},
                                        {"Recombine3DAll", 0},
                                        {"SubdivisionAlgorithm", 0}})
        gmsh::option::setNumber("Mesh." + std::string(option), value);
    const auto [low, high] = bounding_box();
    extent_ = high - low;
}

void Drawing::set_size(double size) const {
    for (const std::string option : {"FromPoints", "FromCurvature", "ExtendFromBoundary"})
        gmsh::option::setNumber("Mesh.MeshSize" + option, 0);
    gmsh::option::setNumber("Mesh.MeshSizeFactor", 1);
    gmsh::model::mesh::removeConstraints();
    double particles = count(dim_, box_content(dim_, extent_), size);
    if (particles > most_particles) {  // perhaps the box is nearly empty
        const double coarse = extent_.maxCoeff() / 20;
        bound_sizes(coarse);
        gmsh::model::mesh::generate(dim_);
        particles = count(dim_, content(dim_), size);
        gmsh::model::mesh::clear();
    }
    if (particles > most_particles)
        throw InvalidInput("--size " + shown(size) + " gives about " + shown(particles, 2) +
                           " particles, more than 5 million; take " +
                           shown(size * std::pow(particles / most_particles, 1.0 / dim_) * 1.1, 2));
    bound_sizes(size);
}

void Drawing::mesh() const {
    gmsh::model::mesh::clear();
    gmsh::model::mesh::generate(dim_);
}

}  // namespace meshes
