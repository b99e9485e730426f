#include "distributed/bytes.hpp"

#include <cstring>
#include <string>
#include <type_traits>
#include <variant>

namespace distributed {

namespace {

/// Adds what it visits to bytes.
struct Writer {
    std::vector<char> bytes;

    template <class Number>
    void visit(const Number* numbers, std::size_t count) {
        const auto* first = reinterpret_cast<const char*>(numbers);
        bytes.insert(bytes.end(), first, first + count * sizeof(Number));
    }
    static constexpr bool reads = false;
};

/// Takes what it visits from bytes.
struct Reader {
    const std::vector<char>& bytes;
    std::size_t place = 0;

    template <class Number>
    void visit(Number* numbers, std::size_t count) {
        if (count > 0) std::memcpy(numbers, bytes.data() + place, count * sizeof(Number));
        place += count * sizeof(Number);
    }
    static constexpr bool reads = true;
};

// How each kind of value lies in the bytes: the same for both.

template <class Archive, class Number,
          std::enable_if_t<std::is_arithmetic_v<Number> || std::is_enum_v<Number>, int> = 0>
void visit(Archive& archive, Number& number) {
    archive.visit(&number, 1);
}

template <class Archive, class Scalar, int rows, int columns, int... more>
void visit(Archive& archive, Eigen::Matrix<Scalar, rows, columns, more...>& matrix) {
    Index width = matrix.cols();
    visit(archive, width);
    if (Archive::reads) matrix.resize(rows, width);
    archive.visit(matrix.data(), static_cast<std::size_t>(matrix.size()));
}

template <class Archive>
void visit(Archive& archive, Column<double>& column) {
    Index size = column.size();
    visit(archive, size);
    if (Archive::reads) column.resize(size);
    archive.visit(column.data(), static_cast<std::size_t>(size));
}

template <class Archive, class Value, std::size_t count>
void visit(Archive& archive, std::array<Value, count>& all) {
    for (Value& one : all) visit(archive, one);
}

template <class Archive>
void visit(Archive& archive, particles::Curve& piece) {
    bool is_arc = std::holds_alternative<particles::Arc>(piece);
    visit(archive, is_arc);
    if (Archive::reads && is_arc) piece.emplace<particles::Arc>();
    if (Archive::reads && !is_arc) piece.emplace<particles::Segment>();
    if (auto* segment = std::get_if<particles::Segment>(&piece)) {
        visit(archive, segment->from);
        visit(archive, segment->to);
    } else {
        auto& arc = std::get<particles::Arc>(piece);
        visit(archive, arc.centre);
        for (double* number : {&arc.radius, &arc.from, &arc.to}) visit(archive, *number);
    }
}

template <class Archive>
void visit(Archive& archive, bodies::Triangle& piece) {
    visit(archive, piece.corners);
}

template <class Archive, int dim>
void visit(Archive& archive, bodies::Place<dim>& place) {
    visit(archive, place.particle);
    visit(archive, place.normal);
}

template <class Archive>
void visit(Archive& archive, std::string& text) {
    std::size_t size = text.size();
    visit(archive, size);
    if (Archive::reads) text.resize(size);
    archive.visit(text.data(), size);
}

template <class Archive, class Value>
void visit(Archive& archive, std::vector<Value>& all);

template <class Archive, int dim>
void visit(Archive& archive, bodies::Side<dim>& side) {
    visit(archive, side.name);
    visit(archive, side.pieces);
    visit(archive, side.places);
}

template <class Archive, class Value>
void visit(Archive& archive, std::vector<Value>& all) {
    std::size_t size = all.size();
    visit(archive, size);
    if (Archive::reads) all.resize(size);
    for (Value& one : all) visit(archive, one);
}

template <class Archive, int dim>
void visit(Archive& archive, Part<dim>& part) {
    Body<dim>& body = part.body;
    visit(archive, body.x);
    visit(archive, body.sides);
    visit(archive, body.cells);
    visit(archive, body.gap);
    visit(archive, part.own_cells);
    visit(archive, part.number);
    visit(archive, part.own);
    Discretisation& how = part.how;
    visit(archive, how.method);
    visit(archive, how.degree);
    visit(archive, how.scaling);
    visit(archive, how.smoothing);
    visit(archive, how.spacing.kind);
    visit(archive, how.spacing.k);
    visit(archive, how.spacing.lengths);
    visit(archive, part.extent.low);
    visit(archive, part.extent.high);
    visit(archive, part.extent.particles);
}

}  // namespace

template <int dim>
std::vector<char> bytes_of(const Part<dim>& part) {
    Writer writer;
    Part<dim> same = part;  // a reader changes what it visits
    visit(writer, same);
    return writer.bytes;
}

template <int dim>
Part<dim> part_from(const std::vector<char>& bytes) {
    Reader reader{bytes};
    Part<dim> part;
    visit(reader, part);
    return part;
}

template std::vector<char> bytes_of(const Part<2>&);
template std::vector<char> bytes_of(const Part<3>&);
template Part<2> part_from(const std::vector<char>&);
template Part<3> part_from(const std::vector<char>&);

}  // namespace distributed
