#pragma once

#include "particles/points.hpp"

namespace meshes {

/// Meshes of the drawing that Gmsh holds, in the same way each time.
class Drawing {
  public:
    explicit Drawing(int dim);

    /// The size of all cells. \throws base::InvalidInput for one with too many particles
    void set_size(double size) const;

    void mesh() const;

  private:
    int dim_;
    particles::Point<3> extent_;
};

}  // namespace meshes
