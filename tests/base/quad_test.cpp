#include "base/quad.hpp"

#include <doctest/doctest.h>

#include "particles/kernels.hpp"
#include "particles/local_system.hpp"

using base::Quad;

TEST_CASE("quad: 113 bits, in numbers, functions, kernels and local systems") {
    CHECK(std::numeric_limits<Quad>::digits == 113);
    CHECK(abs(exp(Quad(1)) * exp(Quad(-1)) - 1) < 1e-33);
    // The integral of the Gaussian is one to the precision of the scalar: sums over a lattice converge beyond
    // all powers.
    Quad sum = 0;
    for (int k = -100; k <= 100; ++k) sum += particles::Gaussian<>::W(Quad(k) / 5) / 5;
    CHECK(abs(sum - 1) < 1e-32);
    const Eigen::Matrix<Quad, 3, 3> hilbert{{1, Quad(1) / 2, Quad(1) / 3},
                                            {Quad(1) / 2, Quad(1) / 3, Quad(1) / 4},
                                            {Quad(1) / 3, Quad(1) / 4, Quad(1) / 5}};
    CHECK((hilbert * particles::inverse(hilbert) - Eigen::Matrix<Quad, 3, 3>::Identity())
              .cwiseAbs()
              .maxCoeff() < 1e-30);
}
