#include "distributed/whole.hpp"

#include <algorithm>
#include <utility>

#include "bodies/quality.hpp"
#include "distributed/bytes.hpp"

namespace distributed {

template <int dim>
Whole<dim>::Whole(const Processes& processes, const Grid<dim>& grid)
    : processes_(processes), grid_(grid), particles_(checked_size(grid)) {}

template <int dim>
Whole<dim>::Whole(const Processes& processes, std::unique_ptr<Body<dim>> body)
    : processes_(processes), body_(std::move(body)) {
    particles_ = static_cast<Index>(processes.from(0, body_ ? static_cast<double>(body_->x.cols()) : 0));
}

template <int dim>
std::unique_ptr<Body<dim>> Whole<dim>::small() const {
    if (!grid_) return body_ ? std::make_unique<Body<dim>>(*body_) : nullptr;
    Grid<dim> coarse = *grid_;
    for (Index& count : coarse.count) count = std::min(count, Index{3});
    return std::make_unique<Body<dim>>(body_of(coarse));
}

template <int dim>
Part<dim> Whole<dim>::part(const Discretisation& how, const std::vector<Point<dim>>& places) {
    if (grid_) {
        Part<dim> own;
        processes_.together([&] { own = part_of(*grid_, how, processes_.count(), processes_.rank()); });
        return own;
    }
    std::optional<Owners> owners;
    processes_.together([&] {
        if (!body_) return;
        Discretisation given = how;
        bodies::Cloud<dim> cloud(body_->x);
        given.spacing = particles::Spacing(particles::spacing(cloud, how.spacing));
        approximation_.emplace(std::move(cloud), given);
        owners = owners_of(*body_, *approximation_, bisected<dim>(body_->x, processes_.count()));
    });
    if (!body_) return part_from<dim>(processes_.receive(0));
    for (int process = 1; process < processes_.count(); ++process)
        processes_.send(bytes_of(part_of(*body_, *approximation_, *owners, process, places)), process);
    return part_of(*body_, *approximation_, *owners, 0, places);
}

template <int dim>
std::vector<Point<dim>> Whole<dim>::across_gaps() const {
    std::vector<Point<dim>> places;
    if (approximation_)
        for (const Index I : bodies::across_gaps(*body_, *approximation_)) places.push_back(body_->x.col(I));
    return places;
}

template <int dim>
template <int n>
void Whole<dim>::require_quality(const bodies::Problem<dim, n>& problem) const {
    if (!approximation_) return;
    const auto conditions = bodies::conditions(problem, *body_);
    static_cast<void>(bodies::checked_quality(
        *body_, *approximation_,
        bodies::highest_derivatives<dim, n>(conditions, approximation_->how().method)));
}

template class Whole<2>;
template class Whole<3>;
template void Whole<2>::require_quality(const bodies::Problem<2, 1>&) const;
template void Whole<3>::require_quality(const bodies::Problem<3, 1>&) const;
template void Whole<2>::require_quality(const bodies::Problem<2, 2>&) const;
template void Whole<3>::require_quality(const bodies::Problem<3, 3>&) const;

}  // namespace distributed
