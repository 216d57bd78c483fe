#pragma once

#include <bit>

#include "rt/batch.h"
#include "rt/tree/bvh.h"
#include "rt/tree/meetings.h"

/// Rays of a batch on their way through the tree, all at once, one node after the other.
///
/// A step has no branches: rays go different ways, so a processor would guess most of them wrong, and while one ray
/// waits for its node the others go on. Items whose boxes are met are put in one list for all rays, so that the tests
/// of what is in them are one loop over that list.
namespace rt {

/// The rays in the tree's space, in single precision: a plane x = c of a box is met at c inverse - shift. Each ray
/// starts where it enters the whole, so that numbers stay near 1 however far the eye is.
struct alignas(64) Journeys {
    float inverse[3][lanes], inverse_out[3][lanes];
    float shift_in[3][lanes], shift_out[3][lanes];  // of the planes where it enters boxes, and where it leaves them
    float far[lanes];                               // the nearest hit so far
    Real start[lanes], per_unit[lanes];             // far = (t - start) per_unit
    Real slack[lanes];
    int met_items[lanes];                           // in the last step
    Index near_side[3][lanes], far_side[3][lanes];  // which of a node's bounds are met first, and last
    Index turn[3][lanes];                           // 7: children far along the axis are far; 0: they are near
    int depth[lanes];                               // of the stack; its place 0 is not in use
    // distance of a box << 32 | its node; the nearest about last
    std::uint64_t stack[lanes][(Bvh::deepest + 1) * Bvh::width];
};

/// Single precision's share of the boxes' margin: roundings of numbers up to 4, eight times over.
constexpr Real box_margin = 0x1p-19;

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
    const vec3 center = bvh.center;
    const Real scale = bvh.scale, reach = std::max(largest(whole.low), largest(whole.high));
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const vec3 o = b.origin.at(i), d = b.direction.at(i);
        const Real margin = 32 * roundoff * (largest(o) + reach);
        const Real speed = largest(d), over_speed = 1 / speed;
        Real enter = -inf, leave = inf;
        vec3 over(0);
        for (int a = 0; a < 3; ++a) {
            const Real part = d[a] * over_speed, size = std::abs(part);
            over[a] = std::copysign(1 / (size > 0x1p-60 ? size : 0x1p-60), part);
            const Real one = (whole.low[a] - margin - o[a]) * over[a];
            const Real other = (whole.high[a] + margin - o[a]) * over[a];
            const Real in = over[a] < 0 ? other : one, out = over[a] < 0 ? one : other;
            enter = in > enter ? in : enter;
            leave = out < leave ? out : leave;
        }
        const Real near = b.near[i] * speed;
        const Real from = near > enter ? near : enter;
        const bool meets = b.near[i] < b.far[i] && from <= leave && i < b.count;
        const Real local_margin = margin * scale, wide = box_margin + local_margin;
        const Real most = 8;  // wider than that, a box is met wherever it is
        const Real m = wide < most ? wide : most;
        for (int a = 0; a < 3; ++a) {
            const Real at = ((o[a] - center[a]) + from * (d[a] * over_speed)) * scale;
            const Real inside = at > 2 ? 2 : at < -2 ? -2 : at;
            const Real over_out = over[a] * (1 + 0x1p-20);  // numbers have relative errors, too
            const Real aside = over[a] < 0 ? -m : m;
            j.inverse[a][i] = float(over[a]), j.inverse_out[a][i] = float(over_out);
            j.shift_in[a][i] = float((inside + aside) * over[a]);
            j.shift_out[a][i] = float((inside - aside) * over_out);
            const int low = a * Bvh::width, high = (3 + a) * Bvh::width;
            j.near_side[a][i] = over[a] < 0 ? high : low, j.far_side[a][i] = over[a] < 0 ? low : high;
            j.turn[a][i] = over[a] < 0 ? 0 : 7;
        }
        j.start[i] = from * over_speed;
        j.per_unit[i] = speed * scale;
        // Grazing, a hit's own distance is less certain: a box is left out only where it is farther by more than that.
        j.slack[i] = 8 * box_margin + 0x1p20 * local_margin;
        const Real far = (b.far[i] - j.start[i]) * j.per_unit[i] + j.slack[i];
        j.far[i] = float(far < 1e30 ? far : 1e30);
        j.depth[i] = meets ? 1 : 0;
    }
    for (int i = 0; i < b.count; ++i) j.stack[i][0] = j.stack[i][1] = 0;
}

/// Which children of its node a ray meets, and what its stack or the list is to hold of each.
struct alignas(64) Children {
    std::uint64_t value[Bvh::width];
    std::uint32_t meets[Bvh::width];  // 1 or 0
    unsigned turn;
    int leaf;
};

/// Takes the node on top of ray i's stack.
inline void look_at_node(const Bvh::Node* nodes, const Journeys& j, int i, Children& children) {
    const Bvh::Node& node = nodes[std::uint32_t(j.stack[i][j.depth[i]])];
    const float x = j.inverse[0][i], y = j.inverse[1][i], z = j.inverse[2][i];
    const float x_out = j.inverse_out[0][i], y_out = j.inverse_out[1][i], z_out = j.inverse_out[2][i];
    const float in_x = j.shift_in[0][i], in_y = j.shift_in[1][i], in_z = j.shift_in[2][i];
    const float out_x = j.shift_out[0][i], out_y = j.shift_out[1][i], out_z = j.shift_out[2][i];
    const float *low_x = node.bound[0][0] + j.near_side[0][i], *high_x = node.bound[0][0] + j.far_side[0][i];
    const float *low_y = node.bound[0][0] + j.near_side[1][i], *high_y = node.bound[0][0] + j.far_side[1][i];
    const float *low_z = node.bound[0][0] + j.near_side[2][i], *high_z = node.bound[0][0] + j.far_side[2][i];
    const float far = j.far[i];
    const bool leaf = node.leaf != 0;
    children.turn = unsigned(j.turn[node.axis][i]);
    children.leaf = int(node.leaf);
#pragma GCC ivdep
    for (int c = 0; c < Bvh::width; ++c) {
        const float enter_x = low_x[c] * x - in_x, leave_x = high_x[c] * x_out - out_x;
        const float enter_y = low_y[c] * y - in_y, leave_y = high_y[c] * y_out - out_y;
        const float enter_z = low_z[c] * z - in_z, leave_z = high_z[c] * z_out - out_z;
        const float enter_xy = enter_x > enter_y ? enter_x : enter_y, enter_z0 = enter_z > 0 ? enter_z : 0;
        const float leave_xy = leave_x < leave_y ? leave_x : leave_y, leave_zf = leave_z < far ? leave_z : far;
        const float enter = enter_xy > enter_z0 ? enter_xy : enter_z0;
        const float leave = leave_xy < leave_zf ? leave_xy : leave_zf;
        children.meets[c] = enter <= leave;
        children.value[c] =
            std::uint64_t(leaf ? std::uint32_t(i) : std::bit_cast<std::uint32_t>(enter)) << 32 | node.child[c];
    }
}

/// Puts the children that are met onto ray i's stack, if they are nodes; if items, into the list.
inline void take_children(const Bvh::Node* nodes, Journeys& j, int i, const Children& children, Meetings& meetings) {
    std::uint64_t* const stack = j.stack[i];
    const int depth = j.depth[i] - 1, leaf = children.leaf;
    std::uint64_t* const tops[2] = {stack + depth + 1, meetings.pair + meetings.count};
    std::uint64_t* const to = tops[leaf];
    // Far children first, as their order along the axis has it. What is not met is overwritten by what follows.
    unsigned met = 0;
    for (unsigned c = 0; c < Bvh::width; ++c) {
        to[met] = children.value[c ^ children.turn];
        met += children.meets[c ^ children.turn];
    }
    meetings.count += int(met) * leaf;
    j.met_items[i] = int(met) * leaf;
    j.depth[i] = depth + int(met) * (1 - leaf);
    // What comes next is fetched while other rays make their steps.
    const Bvh::Node* const next = nodes + std::uint32_t(stack[j.depth[i]]);
    for (int line = 0; line < 4; ++line) __builtin_prefetch(reinterpret_cast<const char*>(next) + 64 * line);
}

/// Takes n rays one node further. First all look, then all go on: a processor that cannot tell whether one ray's stack
/// is another's would let each wait for the one before.
inline void step(const Bvh::Node* nodes, Journeys& j, const int* rays, int n, Meetings& meetings) {
    Children children[lanes];
    for (int k = 0; k < n; ++k) look_at_node(nodes, j, rays[k], children[k]);
    for (int k = 0; k < n; ++k) take_children(nodes, j, rays[k], children[k], meetings);
}

/// Ray i has met something at t: what is farther is forgotten.
inline void shorten(Journeys& j, int i, Real t) {
    const Real far = (t - j.start[i]) * j.per_unit[i] + j.slack[i];
    j.far[i] = float(far < 1e30 ? far : 1e30);
    int left = 0;
    for (int k = 1; k <= j.depth[i]; ++k)
        if (std::bit_cast<float>(std::uint32_t(j.stack[i][k] >> 32)) <= j.far[i]) j.stack[i][++left] = j.stack[i][k];
    j.depth[i] = left;
}

}  // namespace rt
