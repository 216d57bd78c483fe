#pragma once

#include "rt/batch.h"
#include "rt/tree/bvh.h"

/// Pairs of a ray and a shape that may meet. Nobody needs this file for the assignment.
namespace rt {

/// Some of the pairs, number by number in short lists, so that a loop that calls a fragment for each becomes vectors.
constexpr int pairs_at_once = 8;

/// Which rays meet the boxes of which items, lane << 32 | item, and the distances to be found. They are tested when
/// there are `enough`, and a leaf adds at most all of its items for each ray.
struct alignas(64) Meetings {
    static constexpr int enough = 4 * pairs_at_once, most = enough + lanes * Bvh::width;
    std::uint64_t pair[most];
    Real distance[most];
    int count = 0;

    Index lane(int k) const { return Index(pair[k] >> 32); }
    Index item(int k) const { return Index(pair[k] & 0xffff'ffff); }
};

/// Leaves that rays have come to, and in which of their boxes; each ray waits in at most one.
struct Visits {
    static constexpr int enough = 16;
    std::uint32_t node[lanes + 1], met[lanes + 1];  // bit c: the ray meets child c
    int lane[lanes + 1];
    int count = 0;
};

using Points = Vectors<pairs_at_once>;

/// Shapes of one kind.
template <class Shape>
struct Shapes;

template <>
struct alignas(64) Shapes<Sphere> {
    Points center;
    Real radius[pairs_at_once];
    Sphere at(int k) const { return {center.at(k), radius[k]}; }
    void set(int k, const Sphere& s) { center.set(k, s.center), radius[k] = s.radius; }
};

template <>
struct alignas(64) Shapes<Triangle> {
    Points a, b, c;
    Triangle at(int k) const { return {a.at(k), b.at(k), c.at(k)}; }
    void set(int k, const Triangle& t) { a.set(k, t.a), b.set(k, t.b), c.set(k, t.c); }
};

template <>
struct alignas(64) Shapes<Quad> {
    Points center, u, v;
    Quad at(int k) const { return {center.at(k), u.at(k), v.at(k)}; }
    void set(int k, const Quad& q) { center.set(k, q.center), u.set(k, q.u), v.set(k, q.v); }
};

template <>
struct alignas(64) Shapes<Disc> {
    Points center, normal;
    Real radius[pairs_at_once];
    Disc at(int k) const { return {center.at(k), normal.at(k), radius[k]}; }
    void set(int k, const Disc& d) { center.set(k, d.center), normal.set(k, d.normal), radius[k] = d.radius; }
};

struct alignas(64) Rays {
    Points origin, direction;
    Real near[pairs_at_once], far[pairs_at_once];
    Ray at(int k) const { return {origin.at(k), direction.at(k), near[k], far[k]}; }
};

}  // namespace rt
