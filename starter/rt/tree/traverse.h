#pragma once

#include <bit>

#include "rt/batch.h"
#include "rt/tree/bvh.h"
#include "rt/tree/floats.h"
#include "rt/tree/meetings.h"

/// Rays of a batch on their way through the tree, all at once, one node after the other. Nobody needs this file for the
/// assignment.
///
/// A step has no branches: rays go different ways, so a processor would guess most of them wrong, and while one ray
/// waits for its node the others go on. Items whose boxes are met are put in one list for all rays, so that the tests
/// of what is in them are one loop over that list.
namespace rt {

/// The rays in the tree's space, in single precision: a plane x = c of a box is met at c inverse - shift. Each ray
/// starts where it enters the whole, so that numbers stay near 1 however far the eye is.
struct alignas(64) Journeys {
    float inside[3][lanes], part[3][lanes];  // where it starts, and its direction, the largest part 1
    float inverse[3][lanes];
    float shift_in[3][lanes], shift_out[3][lanes];  // of the planes where it enters boxes, and where it leaves them
    float margin[lanes];
    std::int32_t near_side[3][lanes];    // where in Node::bound the planes are that it meets first
    std::int32_t turn[3][lanes];         // 7 where it runs up an axis, so that the last child is the farthest; else 0
    float far[lanes];                    // the nearest hit so far; below 0: nothing is left to find
    Real start[lanes], per_unit[lanes];  // far = (t - start) per_unit + slack
    Real slack[lanes];
    int depth[lanes];                // of the stack; its place 0 is not in use
    static constexpr int room = 64;  // for nodes that a beam leaves to a ray
    // distance of a box << 32 | its node; the nearest about last
    std::uint64_t stack[lanes][room + (Bvh::deepest + 1) * Bvh::width];
};

/// Single precision's share of the boxes' margin: roundings of numbers up to 4, eight times over.
constexpr Real box_margin = 0x1p-19;

/// What the starts of rays need on the way, in double precision.
struct alignas(64) Entrances {
    Real margin[lanes], over_speed[lanes];
    Vectors<> over;                   // 1 / the direction, the largest part 1
    Real enter[lanes], leave[lanes];  // the box of the whole
};

/// Where the rays enter and leave the slab of the whole along an axis.
[[gnu::always_inline]] inline void enter_slab(Real low, Real high, const Real* origin, const Real* direction,
                                              Entrances& e, Real* over) {
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Real part = direction[i] * e.over_speed[i], size = std::abs(part);
        over[i] = std::copysign(1 / (size > 0x1p-60 ? size : 0x1p-60), part);
        const Real one = (low - e.margin[i] - origin[i]) * over[i], other = (high + e.margin[i] - origin[i]) * over[i];
        const Real in = one < other ? one : other, out = one < other ? other : one;
        e.enter[i] = in > e.enter[i] ? in : e.enter[i];
        e.leave[i] = out < e.leave[i] ? out : e.leave[i];
    }
}

/// The rays along an axis, in the tree's space, from where they enter.
[[gnu::always_inline]] inline void start_along(int a, const Bvh& bvh, const Real* origin, const Real* direction,
                                               const Entrances& e, const Real* over, Journeys& j) {
    const Real center = bvh.center[a], scale = bvh.scale;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Real part = direction[i] * e.over_speed[i], at = ((origin[i] - center) + e.enter[i] * part) * scale;
        const Real below = at < 2 ? at : 2, inside = below > -2 ? below : -2;
        const Real aside = std::copysign(e.margin[i], part);
        const std::int32_t down = over[i] < 0;
        j.inside[a][i] = float(inside), j.part[a][i] = float(part);
        j.inverse[a][i] = float(over[i]);
        j.near_side[a][i] = (2 * a + down) * Bvh::width, j.turn[a][i] = down ? 0 : Bvh::width - 1;
        j.shift_in[a][i] = float((inside + aside) * over[i]);
        j.shift_out[a][i] = float((inside - aside) * over[i]);
    }
}

/// Starts the rays of a batch that have an interval left and meet the box of the whole.
///
/// All boxes are widened: by some roundings of the largest numbers that take part in finding a hit, in double
/// precision, so that none is missed that an item's test finds; and by roundings of what the tree itself computes. No
/// component of a direction is 0 here: 2^-60 moves no ray by more than the margin, and then no quotient is infinite or
/// 0/0.
///
/// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; Ize, "Robust BVH Ray Traversal", JCGT 2(2),
/// 2013.
inline void start(const Bvh& bvh, const Batch& b, Journeys& j) {
    const Box whole = bvh.whole;
    const Real scale = bvh.scale, reach = std::max(largest(whole.low), largest(whole.high));
    Entrances e;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const vec3 o = b.origin.at(i), d = b.direction.at(i);
        const Real speed = largest(d);
        e.margin[i] = 32 * roundoff * (largest(o) + reach);
        e.over_speed[i] = 1 / speed;
        e.enter[i] = b.near[i] * speed, e.leave[i] = inf;
        j.per_unit[i] = speed * scale;
    }
    enter_slab(whole.low.x, whole.high.x, b.origin.x, b.direction.x, e, e.over.x);
    enter_slab(whole.low.y, whole.high.y, b.origin.y, b.direction.y, e, e.over.y);
    enter_slab(whole.low.z, whole.high.z, b.origin.z, b.direction.z, e, e.over.z);
    const int count = b.count;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const vec3 none = 0.0 * b.origin.at(i) + (0 * e.over_speed[i]) * b.direction.at(i);
        const bool finite = none == vec3(0);
        const bool meets = finite & bool(b.near[i] < b.far[i]) & bool(e.enter[i] <= e.leave[i]);
        const Real margin = e.margin[i] * scale, wide = box_margin + margin;
        const Real most = 8;  // wider than that, a box is met wherever it is
        e.margin[i] = wide < most ? wide : most;
        j.margin[i] = float(e.margin[i]);
        j.start[i] = e.enter[i] * e.over_speed[i];
        // Grazing, a hit's own distance is less certain: a box is left out only where it is farther by more than that.
        j.slack[i] = 8 * box_margin + 0x1p20 * margin;
        const Real far = (b.far[i] - j.start[i]) * j.per_unit[i] + j.slack[i], near_far = far < 1e30 ? far : 1e30;
        j.far[i] = float(meets ? near_far : -1);
    }
    for (int i = count; i < lanes; ++i) j.far[i] = -1;
    start_along(0, bvh, b.origin.x, b.direction.x, e, e.over.x, j);
    start_along(1, bvh, b.origin.y, b.direction.y, e, e.over.y, j);
    start_along(2, bvh, b.origin.z, b.direction.z, e, e.over.z, j);
}

/// Puts the root on the stack of each ray, or nothing.
inline void begin(Journeys& j, bool at_root) {
    for (int i = 0; i < lanes; ++i) {
        j.depth[i] = at_root & (j.far[i] >= 0);
        j.stack[i][0] = j.stack[i][1] = 0;
    }
}

/// Where ray i meets the children of a node. Returns which: bit c, child c.
[[gnu::always_inline]] inline unsigned look(const Bvh::Node& node, const Journeys& j, int i, Ways& ways) {
    const float* const bounds = node.bound[0][0];
    const float *first[3], *last[3];
    for (int a = 0; a < 3; ++a) {
        first[a] = bounds + j.near_side[a][i];
        last[a] = bounds + (j.near_side[a][i] ^ Bvh::width);
    }
    const float far = j.far[i];
    unsigned met = 0;
    for (int c = 0; c < Bvh::width; c += half_wide) {
        FewFloats enter = FewFloats{}, leave = enter + far;
        for (int a = 0; a < 3; ++a) {
            const float inverse = j.inverse[a][i];
            enter = greater(load<FewFloats>(first[a] + c) * inverse - j.shift_in[a][i], enter);
            leave = lesser(load<FewFloats>(last[a] + c) * inverse - j.shift_out[a][i], leave);
        }
        std::memcpy(ways.enter + c, &enter, sizeof enter);
        std::memcpy(ways.leave + c, &leave, sizeof leave);
        met |= not_above(enter, leave) << c;
    }
    return met;
}

/// Fetches a node, or the corners of a leaf, that are needed soon.
template <class T>
void fetch(const T& what) {
    for (std::size_t k = 0; k < sizeof what; k += 64) __builtin_prefetch(reinterpret_cast<const char*>(&what) + k);
}

/// Takes ray i one node further. The children that it meets go onto its stack, if they are nodes; if they are items,
/// the leaf goes into the list. Returns whether it does.
[[gnu::always_inline]] inline bool step(const Bvh::Node* nodes, Journeys& j, int i, Visits& visits) {
    std::uint64_t* const top = j.stack[i] + j.depth[i];
    const std::uint32_t number = std::uint32_t(*top);
    const Bvh::Node& node = nodes[number];
    Ways ways;
    const unsigned met = look(node, j, i, ways);
    write_met(ways, node.child, unsigned(j.turn[node.axis][i]), top);
    j.depth[i] += int(unsigned(std::popcount(met)) & ~node.leaf) - 1;
    const bool items = (met & node.leaf) != 0;
    visits.node[visits.count] = number, visits.met[visits.count] = met, visits.lane[visits.count] = i;
    visits.count += items;
    return items;
}

/// Puts a ray and some children of a leaf into the list. Returns how many.
[[gnu::always_inline]] inline int add_pairs(const Bvh::Node& leaf, int lane, unsigned met, Meetings& meetings) {
    int n = 0;
    for (; met; met &= met - 1, ++n)
        meetings.pair[meetings.count + n] = std::uint64_t(lane) << 32 | leaf.child[std::countr_zero(met)];
    meetings.count += n;
    return n;
}

/// Ray i has met something at t.
inline void set_far(Journeys& j, int i, Real t) {
    const Real far = (t - j.start[i]) * j.per_unit[i] + j.slack[i];
    j.far[i] = float(far < 1e30 ? far : 1e30);
}

/// And what is farther is forgotten.
inline void shorten(Journeys& j, int i, Real t) {
    set_far(j, i, t);
    int left = 0;
    for (int k = 1; k <= j.depth[i]; ++k)
        if (std::bit_cast<float>(std::uint32_t(j.stack[i][k] >> 32)) <= j.far[i]) j.stack[i][++left] = j.stack[i][k];
    j.depth[i] = left;
}

}  // namespace rt
