#include <cmath>
#include <memory>

#include "batra2008/basis_at.hpp"
#include "batra2008/section_4_1_plate.hpp"
#include "batra2008/section_4_example_problems.hpp"
#include "tests/benchmarks/report.hpp"

namespace benchmarks {

namespace {

using namespace batra2008;

/// The plate with about so many particles.
std::shared_ptr<const Cloud<2>> plate_of(long particles) {
    const auto ny = std::lround(std::sqrt(static_cast<double>(particles) / 5));
    return std::make_shared<const Cloud<2>>(plate::grid(5 * ny - 4, ny));
}

}  // namespace

void add_batra2008(long most) {
    const double scaling = 3;
    for (long N = 1000; N <= most; N *= 10)
        for (const int threads : {1, 2}) {
            const long size = plate_of(N)->size();
            add({"search", "cells", size, threads}, [=] {
                return [cloud = plate_of(N), scaling] {
                    base::for_each_index(cloud->size(), [&](Index I) {
                        benchmark::DoNotOptimize(
                            cloud->within(cloud->x().col(I), scaling * cloud->apart()[I]).data());
                    });
                };
            });
            add({"basis", "m = 2", size, threads}, [=] {
                const auto cloud = plate_of(N);
                std::vector<std::vector<int>> near(static_cast<std::size_t>(cloud->size()));
                for (Index I = 0; I < cloud->size(); ++I)
                    near[static_cast<std::size_t>(I)] =
                        cloud->within(cloud->x().col(I), scaling * cloud->apart()[I]);
                return [cloud, near, kernel = Kernel(scaling)] {
                    base::for_each_index(cloud->size(), [&](Index I) {
                        const Point<2> x = cloud->x().col(I);
                        const auto& among = near[static_cast<std::size_t>(I)];
                        benchmark::DoNotOptimize(
                            ssph_basis::basis_at<2>(*cloud, kernel, x, cloud->apart()[I], among).K().data());
                    });
                };
            });
        }
    for (const auto method :
         {example_problems::Method::strong, example_problems::Method::weak1, example_problems::Method::weak2})
        for (long N = 1000; N <= most; N *= 10) {
            const elastostatics::Material material{plate::E, plate::nu, elastostatics::Plane::stress};
            const Problem problem = plate::problem(material);
            example_problems::Discretisation how;
            how.method = method;
            how.scaling = 4;
            how.penalty = plate::penalty(material);
            const long size = plate_of(N)->size();
            for (const int threads : {1, 2})
                if (threads == 2 || N <= 10000)
                    add({"plate assembly", example_problems::name(method), size, threads, 0, 0, true}, [=] {
                        return [=, cloud = plate_of(N)] {
                            benchmark::DoNotOptimize(example_problems::system(problem, *cloud, how).b.data());
                        };
                    });
            add({"plate in all", example_problems::name(method), size, 2, 0, 0, true}, [=] {
                return [=, cloud = plate_of(N)] {
                    benchmark::DoNotOptimize(example_problems::solve(problem, *cloud, how).u.data());
                };
            });
        }
}

}  // namespace benchmarks
