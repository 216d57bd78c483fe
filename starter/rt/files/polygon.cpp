#include "rt/files/polygon.h"

#include <algorithm>

namespace rt {
namespace {

using Triangles = std::vector<std::array<int, 3>>;

constexpr std::size_t most_corners = 4096;

/// Roundings: of a polygon of size 1, what is no turn.
constexpr Real straight = 1e-12;

/// Twice the area of the triangle a b c; negative if it runs clockwise.
Real turn(vec2 a, vec2 b, vec2 c) { return difference_of_products(b.x - a.x, c.y - a.y, b.y - a.y, c.x - a.x); }

/// Where the corners are in the plane of the polygon, of size 1, anticlockwise; empty: it has no area.
std::vector<vec2> flattened(const std::vector<vec3>& corners, const std::vector<int>& places) {
    Real size = 0;
    const vec3 first = corners[std::size_t(places[0])];
    for (const int i : places) size = std::max(size, largest(corners[std::size_t(i)] - first));
    if (!(size > 0)) return {};
    vec3 area(0);
    std::vector<vec3> scaled;
    for (const int i : places) scaled.push_back((corners[std::size_t(i)] - first) / size);
    for (std::size_t i = 0; i < scaled.size(); ++i) area += exact_cross(scaled[i], scaled[(i + 1) % scaled.size()]);
    const vec3 normal = unit(area);
    if (!(length(area) > straight)) return {};
    const Frame frame = frame_about(normal);
    std::vector<vec2> flat;
    for (const vec3 p : scaled) flat.emplace_back(dot(p, frame.x), dot(p, frame.y));
    return flat;
}

/// Whether the outline turns left at every corner, and once in all.
bool is_convex(const std::vector<vec2>& p) {
    const std::size_t n = p.size();
    Real angle = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const vec2 a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
        const Real left = turn(a, b, c);
        if (left < -straight) return false;
        angle += std::atan2(left, dot(b - a, c - b));
    }
    return angle < 3 * pi;
}

/// Whether two edges without a common end cross.
bool crosses_itself(const std::vector<vec2>& p) {
    const std::size_t n = p.size();
    const auto apart = [](Real a, Real b) {
        return (a > straight && b < -straight) || (a < -straight && b > straight);
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 2; j < n; ++j) {
            const vec2 a = p[i], b = p[i + 1], c = p[j], d = p[(j + 1) % n];
            if (i == 0 && j + 1 == n) continue;
            if (apart(turn(a, b, c), turn(a, b, d)) && apart(turn(c, d, a), turn(c, d, b))) return true;
        }
    return false;
}

/// Whether a corner lies in the triangle or on its edges, and is none of its own.
bool stands_in(vec2 q, vec2 a, vec2 b, vec2 c) {
    if (q == a || q == b || q == c) return false;
    return turn(a, b, q) >= 0 && turn(b, c, q) >= 0 && turn(c, a, q) >= 0;
}

/// Cuts off corner after corner.
std::optional<Triangles> cut_ears(const std::vector<vec2>& p, const std::vector<int>& places) {
    std::vector<std::size_t> left(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) left[i] = i;
    Triangles triangles;
    while (left.size() > 2) {
        const std::size_t n = left.size();
        const auto corner = [&](std::size_t i) { return p[left[i % n]]; };
        const auto is_ear = [&](std::size_t i) {
            const vec2 a = corner(i), b = corner(i + 1), c = corner(i + 2);
            if (!(turn(a, b, c) > straight)) return false;
            return std::none_of(left.begin(), left.end(), [&](std::size_t k) { return stands_in(p[k], a, b, c); });
        };
        std::size_t ear = 0;
        while (ear < n && !is_ear(ear)) ++ear;
        if (ear < n)
            triangles.push_back({places[left[ear]], places[left[(ear + 1) % n]], places[left[(ear + 2) % n]]});
        else
            for (ear = 0; ear < n && std::abs(turn(corner(ear), corner(ear + 1), corner(ear + 2))) > straight;) ++ear;
        if (ear == n) return std::nullopt;
        left.erase(left.begin() + std::ptrdiff_t((ear + 1) % n));
    }
    return triangles;
}

}  // namespace

std::optional<Triangles> split_polygon(const std::vector<vec3>& corners) {
    std::vector<int> places;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (corners[i] != corners[(i + corners.size() - 1) % corners.size()]) places.push_back(int(i));
    Triangles triangles;
    if (places.size() < 3) return triangles;
    const auto fan = [&] {
        for (std::size_t i = 2; i < places.size(); ++i) triangles.push_back({places[0], places[i - 1], places[i]});
        return triangles;
    };
    if (places.size() == 3) return fan();
    const std::vector<vec2> flat = flattened(corners, places);
    if (flat.empty()) {
        // Without area: all on one line, or as much one way round as the other.
        for (std::size_t i = 2; i < places.size(); ++i) {
            const vec3 a = corners[std::size_t(places[0])], b = corners[std::size_t(places[i - 1])],
                       c = corners[std::size_t(places[i])];
            const Real size = std::max(largest(b - a), largest(c - a));
            if (size > 0 && length(exact_cross((b - a) / size, (c - a) / size)) > straight) return std::nullopt;
        }
        return triangles;
    }
    if (is_convex(flat)) return fan();
    if (flat.size() > most_corners || crosses_itself(flat)) return std::nullopt;
    return cut_ears(flat, places);
}

}  // namespace rt
