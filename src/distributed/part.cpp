#include "distributed/part.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "bodies/integrals.hpp"

namespace distributed {

namespace {

template <class List>
auto& at(List& list, Index k) {
    return list[static_cast<std::size_t>(k)];
}

template <int dim>
void bisect(const particles::Points<dim>& x, std::vector<int>::iterator begin, std::vector<int>::iterator end,
            int first, int processes, std::vector<int>& process) {
    if (processes == 1 || begin == end) {
        for (auto I = begin; I != end; ++I) at(process, *I) = first;
        return;
    }
    Point<dim> low = x.col(*begin), high = low;
    for (auto I = begin; I != end; ++I) {
        low = low.cwiseMin(x.col(*I));
        high = high.cwiseMax(x.col(*I));
    }
    Index axis = 0;
    (high - low).maxCoeff(&axis);
    const auto middle = begin + share_of_first_half(end - begin, processes);
    std::nth_element(begin, middle, end,
                     [&](int a, int b) { return std::pair(x(axis, a), a) < std::pair(x(axis, b), b); });
    bisect<dim>(x, begin, middle, first, processes / 2, process);
    bisect<dim>(x, middle, end, first + processes / 2, processes - processes / 2, process);
}

/// The points of a rule on one piece.
template <int dim>
std::vector<bodies::IntegrationPoint<dim>> rule_on(const bodies::Piece<dim>& piece, double spacing) {
    return bodies::rule_on(bodies::Side<dim>{"", {piece}, {}}, spacing);
}

std::vector<Point<2>> ends_of(const bodies::Piece<2>& piece) {
    const auto* segment = std::get_if<particles::Segment>(&piece);
    if (segment == nullptr) return {};
    return {segment->from, segment->to};
}
std::vector<Point<3>> ends_of(const bodies::Piece<3>& piece) {
    return {piece.corners.begin(), piece.corners.end()};
}

template <int dim>
Point<dim> centre(const Body<dim>& body, const std::array<int, dim + 1>& cell) {
    Point<dim> sum = Point<dim>::Zero();
    for (const int I : cell) sum += body.x.col(I);
    return sum / (dim + 1);
}

/// Calls `work(side, piece, owner)` for each piece of a body: number of its side, piece, owning process.
template <int dim, class Work>
void for_each_piece(const Body<dim>& body, const Owners& owners, const Work& work) {
    for (std::size_t k = 0; k < body.sides.size(); ++k)
        for (std::size_t j = 0; j < body.sides[k].pieces.size(); ++j)
            work(k, body.sides[k].pieces[j], owners.piece[k][j]);
}

}  // namespace

template <int dim>
Approximation<dim> approximation_of(const Part<dim>& part) {
    const double volume = std::pow(part.extent.spacing(), dim);
    return Approximation<dim>(
        bodies::Cloud<dim>(part.body.x, Column<double>::Constant(part.body.x.cols(), volume)), part.how);
}

template <int dim>
std::vector<bodies::IntegrationPoint<dim>> rule_in(const Part<dim>& part) {
    const Body<dim> own{part.body.x, {}, {part.body.cells.begin(), part.body.cells.begin() + part.own_cells}};
    if (own.cells.empty()) return {};
    return bodies::rule_in(own);
}

template <int dim>
std::vector<int> bisected(const particles::Points<dim>& x, int processes) {
    std::vector<int> particles(static_cast<std::size_t>(x.cols())), process(particles.size());
    std::iota(particles.begin(), particles.end(), 0);
    bisect<dim>(x, particles.begin(), particles.end(), 0, processes, process);
    return process;
}

template <int dim>
Owners owners_of(const Body<dim>& body, const Approximation<dim>& approximation, std::vector<int> particle) {
    Owners owners{std::move(particle), {}, {}};
    const double spacing = approximation.cloud().spacing();
    for (const auto& side : body.sides) {
        owners.piece.emplace_back();
        for (const auto& piece : side.pieces) {
            const Point<dim> x = rule_on<dim>(piece, spacing).front().x;
            owners.piece.back().push_back(at(owners.particle, approximation.cloud().nearest(x)));
        }
    }
    for (const auto& cell : body.cells) owners.cell.push_back(at(owners.particle, cell[0]));
    return owners;
}

template <int dim>
Part<dim> part_of(const Body<dim>& body, const Approximation<dim>& approximation, const Owners& owners,
                  int process, const std::vector<Point<dim>>& places) {
    const Index N = body.x.cols();
    const double spacing = approximation.cloud().spacing();
    std::vector<int> place(static_cast<std::size_t>(N), -1);  // in the part; 0 for those that it will have
    const auto take = [&](const auto& some) {
        for (const int I : some) at(place, I) = 0;
    };
    Part<dim> part;
    for (const auto& side : body.sides) part.body.sides.push_back({side.name, {}, {}});
    for (Index I = 0; I < N; ++I)
        if (at(owners.particle, I) == process) take(approximation.neighbours(I));
    for_each_piece<dim>(body, owners, [&](std::size_t side, const auto& piece, int owner) {
        if (owner != process) return;
        part.body.sides[side].pieces.push_back(piece);
        for (const auto& point : rule_on<dim>(piece, spacing)) take(approximation.neighbours_at(point.x));
        for (const Point<dim>& end : ends_of(piece)) take(std::array{approximation.cloud().nearest(end)});
    });
    std::vector<std::array<int, dim + 1>> around;
    for (std::size_t k = 0; k < body.cells.size(); ++k) {
        const auto& cell = body.cells[k];
        if (owners.cell[k] == process) {
            part.body.cells.push_back(cell);
            take(cell);
            take(approximation.neighbours_at(centre<dim>(body, cell)));
        } else if (std::any_of(cell.begin(), cell.end(),
                               [&](int I) { return at(owners.particle, I) == process; })) {
            around.push_back(cell);
            take(cell);
        }
    }
    part.own_cells = static_cast<Index>(part.body.cells.size());
    part.body.cells.insert(part.body.cells.end(), around.begin(), around.end());
    for (const Point<dim>& x : places)
        if (at(owners.particle, approximation.cloud().nearest(x)) == process)
            take(approximation.neighbours_at(x));

    for (Index I = 0; I < N; ++I)
        if (at(place, I) == 0) {
            at(place, I) = static_cast<int>(part.number.size());
            if (at(owners.particle, I) == process) part.own.push_back(at(place, I));
            part.number.push_back(I);
        }
    const auto count = static_cast<Index>(part.number.size());
    part.body.x.resize(dim, count);
    for (Index k = 0; k < count; ++k) part.body.x.col(k) = body.x.col(at(part.number, k));
    for (auto& cell : part.body.cells)
        for (int& I : cell) I = at(place, I);
    for (std::size_t k = 0; k < body.sides.size(); ++k)
        for (const auto& one : body.sides[k].places)
            if (at(place, one.particle) >= 0)
                part.body.sides[k].places.push_back({at(place, one.particle), one.normal});
    part.body.gap = body.gap;
    part.extent = bodies::extent_of(body);
    part.how = approximation.how();
    Column<double>& lengths = part.how.spacing.lengths;
    if (lengths.size() > 1) {
        const Column<double> all = lengths;
        lengths.resize(count);
        for (Index k = 0; k < count; ++k) lengths[k] = all[at(part.number, k)];
    }
    return part;
}

template std::vector<bodies::IntegrationPoint<2>> rule_in(const Part<2>&);
template std::vector<bodies::IntegrationPoint<3>> rule_in(const Part<3>&);
template Approximation<2> approximation_of(const Part<2>&);
template Approximation<3> approximation_of(const Part<3>&);
template std::vector<int> bisected<2>(const particles::Points<2>&, int);
template std::vector<int> bisected<3>(const particles::Points<3>&, int);
template Owners owners_of(const Body<2>&, const Approximation<2>&, std::vector<int>);
template Owners owners_of(const Body<3>&, const Approximation<3>&, std::vector<int>);
template Part<2> part_of(const Body<2>&, const Approximation<2>&, const Owners&, int,
                         const std::vector<Point<2>>&);
template Part<3> part_of(const Body<3>&, const Approximation<3>&, const Owners&, int,
                         const std::vector<Point<3>>&);

}  // namespace distributed
