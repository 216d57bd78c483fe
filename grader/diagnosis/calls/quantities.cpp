#include "diagnosis/calls/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/calls/scalars.h"

namespace grade {

using rt::vec3;

namespace {

/// A vector that calls show: an argument, one mirrored at another, or one of the answer.
struct Vector {
    std::string name;
    std::size_t part;
    bool own;  // of the answer
    int mirror = -1;

    vec3 at(const Row& row, const Layout& l, const Row& output) const {
        if (own) return vector_at(output, part);
        const vec3 d = vector_at(row, l.parts[part].at);
        if (mirror < 0) return d;
        const vec3 n = vector_at(row, l.parts[std::size_t(mirror)].at);
        return d - 2 * rt::dot(d, n) * n;
    }
};

std::vector<Vector> vectors_of(const Layout& layout, const std::vector<bool>& told, const Layout* result) {
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < layout.parts.size(); ++i)
        if (layout.parts[i].kind == Kind::vector && (i >= told.size() || told[i]))
            vectors.push_back({layout.parts[i].name, i, false});
    const std::size_t given = vectors.size();
    if (result)
        for (const Field& part : result->parts)
            if (part.kind == Kind::vector && !part.name.empty())
                vectors.push_back({"the answer's " + part.name, part.at, true});
    // where the answer is a direction: mirrored ones, which it may be measured from
    const bool has_own = given < vectors.size();
    for (std::size_t a = 0; has_own && a < given; ++a)
        for (std::size_t b = 0; b < given; ++b)
            if (a != b)
                vectors.push_back({fmt::format("{} mirrored at {}", vectors[a].name, vectors[b].name), vectors[a].part,
                                   false, int(vectors[b].part)});
    return vectors;
}

using Measured = decltype(Quantity::value);

Quantity length(const std::string& vector, Measured value, std::optional<std::size_t> answer_at = {}) {
    return {fmt::format("|{}|", vector), std::move(value), Quantity::Kind::length, vector, answer_at};
}

Quantity product(const std::string& of, Measured value) {
    return {fmt::format("dot({})", of), std::move(value), Quantity::Kind::product};
}

/// Whether a vector of this name is a direction, not a point: "ray.direction", "to_light", "n".
bool is_direction(const std::string& name) {
    const std::string last = name.substr(name.find_last_of(". ") + 1);
    return last == "n" || last == "d" || last == "direction" || last == "normal" || last.starts_with("to_");
}

/// Lengths, products, and distances of what is alike.
void add_vectors(const std::vector<Vector>& vectors, std::vector<Quantity>& all) {
    for (std::size_t a = 0; a < vectors.size(); ++a) {
        const Vector& v = vectors[a];
        if (v.mirror >= 0) continue;
        all.push_back(length(
            v.name, [=](const Row& row, const Layout& l, const Row& out) { return glm::length(v.at(row, l, out)); },
            v.own ? std::optional(v.part) : std::nullopt));
        for (std::size_t b = a + 1; b < vectors.size(); ++b) {
            const Vector& w = vectors[b];
            if (w.mirror >= 0 && !v.own) continue;
            all.push_back(product(v.name + ", " + w.name, [=](const Row& row, const Layout& l, const Row& out) {
                return rt::dot(v.at(row, l, out), w.at(row, l, out));
            }));
            if (is_direction(v.name) != is_direction(w.name)) continue;
            all.push_back(length(v.name + " - " + w.name, [=](const Row& row, const Layout& l, const Row& out) {
                return glm::length(v.at(row, l, out) - w.at(row, l, out));
            }));
        }
    }
}

/// The part of this name; none: there is none, or it does not matter.
std::optional<std::size_t> part_named(const Layout& layout, const std::vector<bool>& told, const std::string& name) {
    const auto found = std::ranges::find(layout.parts, name, &Field::name);
    const std::size_t i = std::size_t(found - layout.parts.begin());
    if (found == layout.parts.end() || (i < told.size() && !told[i])) return std::nullopt;
    return i;
}

/// From which side a ray comes to a flat shape.
void add_sides(const Layout& layout, const std::vector<bool>& told, std::vector<Quantity>& all) {
    const auto direction = part_named(layout, told, "ray.direction");
    if (!direction) return;
    const auto add = [&](const std::string& words, auto normal) {
        all.push_back(product(fmt::format("cross({}), ray.direction", words),
                              [=, d = *direction](const Row& row, const Layout& l, const Row&) {
                                  const auto at = [&](std::size_t part) { return vector_at(row, l.parts[part].at); };
                                  return rt::dot(normal(at), at(d));
                              }));
    };
    const auto a = part_named(layout, told, "triangle.a"), b = part_named(layout, told, "triangle.b"),
               c = part_named(layout, told, "triangle.c");
    if (a && b && c)
        add("b - a, c - a", [a = *a, b = *b, c = *c](auto at) { return glm::cross(at(b) - at(a), at(c) - at(a)); });
    const auto u = part_named(layout, told, "quad.u"), v = part_named(layout, told, "quad.v");
    if (u && v) add("u, v", [u = *u, v = *v](auto at) { return glm::cross(at(u), at(v)); });
}

void add_answers(const Layout& result, std::vector<Quantity>& all) {
    for (const Field& part : result.parts) {
        const std::string name = "the answer's " + part.name;
        const std::size_t at = part.at;
        if (part.kind == Kind::pair && !part.name.empty())
            all.push_back(length(
                name, [at](const Row&, const Layout&, const Row& out) { return std::hypot(out[at], out[at + 1]); },
                at));
        if (part.kind == Kind::number && part.name == "distance")
            all.push_back({name, [at](const Row&, const Layout&, const Row& out) { return out[at]; },
                           Quantity::Kind::length, "", at});
        if (part.kind == Kind::vector && !part.name.empty())
            all.push_back({name + ".z", [at](const Row&, const Layout&, const Row& out) { return out[at + 2]; },
                           Quantity::Kind::coordinate});
    }
}

}  // namespace

std::vector<Quantity> quantities_of(const Layout& layout, const std::vector<bool>& told, const Layout* result) {
    std::vector<Quantity> all;
    for (const Scalar& s : scalars_of(layout, told))
        all.push_back({s.name, [s](const Row& row, const Layout& l, const Row&) { return row[s.at(l)]; }});
    add_vectors(vectors_of(layout, told, result), all);
    add_sides(layout, told, all);
    if (result) add_answers(*result, all);
    for (std::size_t i = 0; i < layout.lists.size(); ++i)
        all.push_back({fmt::format("the number of {}", layout.lists[i].name),
                       [i](const Row&, const Layout& l, const Row&) { return double(l.lists[i].count); }});
    return all;
}

std::vector<Quantity> as_code(std::vector<Quantity> all) {
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        if (all[i].kind != Quantity::Kind::length || all[i].vector.empty()) continue;
        Quantity square = all[i];
        square.words = fmt::format("dot({0}, {0})", all[i].vector), square.kind = Quantity::Kind::product;
        square.value = [length = all[i].value](const Row& row, const Layout& layout, const Row& output) {
            return std::pow(length(row, layout, output), 2);
        };
        all[i].words = fmt::format("length({})", all[i].vector);
        all.push_back(std::move(square));
    }
    return all;
}

}  // namespace grade
