#include "diagnosis/quantities.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/scalars.h"

namespace grade {

using rt::vec3;

std::vector<Quantity> quantities_of(const Layout& layout, const std::vector<bool>& told, const Layout* result) {
    std::vector<Quantity> all;
    for (const Scalar& s : scalars_of(layout, told))
        all.push_back({s.name, [s](const Row& row, const Layout& l, const Row&) { return row[s.at(l)]; }});
    struct Vector {
        std::string name;
        std::size_t part;
        bool own;  // of the answer
        int mirror = -1;
    };
    std::vector<Vector> vectors;
    for (std::size_t i = 0; i < layout.parts.size(); ++i)
        if (layout.parts[i].kind == Kind::vector && (i >= told.size() || told[i]))
            vectors.push_back({layout.parts[i].name, i, false});
    if (result)
        for (const Field& part : result->parts)
            if (part.kind == Kind::vector && !part.name.empty())
                vectors.push_back({"the answer's " + part.name, part.at, true});
    // where the answer is a direction: mirrored ones, which it may be measured from
    const std::size_t given = vectors.size() - std::size_t(std::ranges::count(vectors, true, &Vector::own));
    const bool has_own = given < vectors.size();
    for (std::size_t a = 0; has_own && a < given; ++a)
        for (std::size_t b = 0; b < given; ++b)
            if (a != b)
                vectors.push_back({fmt::format("{} mirrored at {}", vectors[a].name, vectors[b].name), vectors[a].part,
                                   false, int(vectors[b].part)});
    const auto at = [](const Vector& v, const Row& row, const Layout& l, const Row& output) {
        if (v.mirror >= 0) {
            const vec3 d = vector_at(row, l.parts[v.part].at), n = vector_at(row, l.parts[std::size_t(v.mirror)].at);
            return d - 2 * rt::dot(d, n) * n;
        }
        return v.own ? vector_at(output, v.part) : vector_at(row, l.parts[v.part].at);
    };
    for (std::size_t a = 0; a < vectors.size(); ++a) {
        const Vector v = vectors[a];
        if (v.mirror >= 0) continue;
        all.push_back({fmt::format("|{}|", v.name), [=](const Row& row, const Layout& l, const Row& out) {
                           return glm::length(at(v, row, l, out));
                       }});
        for (std::size_t b = a + 1; b < vectors.size(); ++b) {
            const Vector w = vectors[b];
            if (w.mirror >= 0 && !v.own) continue;
            all.push_back(
                {fmt::format("dot({}, {})", v.name, w.name), [=](const Row& row, const Layout& l, const Row& out) {
                     return rt::dot(at(v, row, l, out), at(w, row, l, out));
                 }});
            all.push_back(
                {fmt::format("|{} - {}|", v.name, w.name), [=](const Row& row, const Layout& l, const Row& out) {
                     return glm::length(at(v, row, l, out) - at(w, row, l, out));
                 }});
        }
    }
    for (std::size_t i = 0; result && i < result->parts.size(); ++i) {
        const Field part = result->parts[i];
        if (part.kind == Kind::pair && !part.name.empty())
            all.push_back(
                {fmt::format("|the answer's {}|", part.name), [part](const Row&, const Layout&, const Row& out) {
                     return std::hypot(out[part.at], out[part.at + 1]);
                 }});
        if (part.kind == Kind::number && part.name == "distance")
            all.push_back({fmt::format("the answer's {}", part.name),
                           [part](const Row&, const Layout&, const Row& out) { return out[part.at]; }});
        if (part.kind == Kind::vector && !part.name.empty())
            all.push_back({fmt::format("the answer's {}.z", part.name),
                           [part](const Row&, const Layout&, const Row& out) { return out[part.at + 2]; }});
    }
    for (std::size_t i = 0; i < layout.lists.size(); ++i) {
        all.push_back({fmt::format("the number of {}", layout.lists[i].name),
                       [i](const Row&, const Layout& l, const Row&) { return double(l.lists[i].count); }});
    }
    return all;
}

}  // namespace grade
