#pragma once

#include <bit>

#include "rt/batch.h"
#include "rt/bvh.h"

/// Rays of a batch on their way through the tree.
///
/// Each ray goes down until it meets boxes of items. The items it must be tested against are handed out, all rays' in one
/// list, so that the tests are one loop over that list; then the rays go on with the distances found.
namespace rt {

/// A ray and an item whose box it meets, and the distance to be found.
struct alignas(64) Meetings {
    static constexpr int most = lanes * Bvh::width;
    Index lane[most], item[most];
    Real distance[most];
    int count = 0;

    void add(int ray, std::uint32_t i) { lane[count] = ray, item[count] = i, ++count; }
};

/// The rays in the tree's space, in single precision: a plane x = c of a box is met at c inverse - shift. Each ray starts
/// where it enters the whole, so that numbers stay near 1 however far the eye is.
struct alignas(64) Journeys {
    float inverse[3][lanes];
    float shift_in[3][lanes], shift_out[3][lanes];  // of the planes where it enters boxes, and where it leaves them
    float far[lanes];                               // the nearest hit so far
    Real start[lanes], per_unit[lanes];             // far = (t - start) per_unit
    Real slack[lanes];
    Index backward[3][lanes];
    int depth[lanes];
    std::uint64_t stack[lanes][Bvh::deepest * (Bvh::width - 1) + 1];  // distance of a box, and its node
};

/// Single precision's share of the boxes' margin: roundings of numbers up to 4, eight times over.
constexpr Real box_margin = 0x1p-19;

inline void set_far(Journeys& j, int i, Real t) {
    const Real far = (t - j.start[i]) * j.per_unit[i] + j.slack[i];
    j.far[i] = float(far < 1e30 ? far : 1e30);
}

/// Starts the rays of a batch that have an interval left and meet the box of the whole.
///
/// All boxes are widened: by some roundings of the largest numbers that take part in finding a hit, in double precision,
/// so that none is missed that an item's test finds; and by roundings of what the tree itself computes. No component of a
/// direction is 0 here: 2^-40 moves no ray by more than the margin, and then no quotient is infinite or 0/0.
///
/// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; Ize, "Robust BVH Ray Traversal", JCGT 2(2),
/// 2013.
inline void start(const Bvh& bvh, const Batch& b, Journeys& j) {
    const Box whole = bvh.whole;
    const vec3 center = bvh.center;
    const Real scale = bvh.scale, reach = std::max(largest(whole.low), largest(whole.high));
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const vec3 o{b.ox[i], b.oy[i], b.oz[i]}, d{b.dx[i], b.dy[i], b.dz[i]};
        const Real margin = 32 * roundoff * (largest(o) + reach);
        const Real speed = largest(d);
        Real enter = -inf, leave = inf;
        vec3 along;
        for (int a = 0; a < 3; ++a) {
            const Real part = d[a] / speed, size = std::abs(part);
            const Real away = std::copysign(size > 1e-300 ? size : 1e-300, part);
            along[a] = std::copysign(size > 0x1p-40 ? size : 0x1p-40, part);
            const Real one = (whole.low[a] - margin - o[a]) / away, other = (whole.high[a] + margin - o[a]) / away;
            const Real in = away < 0 ? other : one, out = away < 0 ? one : other;
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
            const Real at = ((o[a] - center[a]) + from * (d[a] / speed)) * scale;
            const Real inside = at > 2 ? 2 : at < -2 ? -2 : at;
            const Real over = 1 / along[a], aside = over < 0 ? -m : m;
            j.inverse[a][i] = float(over);
            j.shift_in[a][i] = float((inside + aside) * over);
            j.shift_out[a][i] = float((inside - aside) * over);
            j.backward[a][i] = over < 0 ? 1 : 0;
        }
        j.start[i] = from / speed;
        j.per_unit[i] = speed * scale;
        // Grazing, a hit's own distance is less certain: a box is left out only where it is farther by more than that.
        j.slack[i] = 8 * box_margin + 0x1p20 * local_margin;
        const Real far = (b.far[i] - j.start[i]) * j.per_unit[i] + j.slack[i];
        j.far[i] = float(far < 1e30 ? far : 1e30);
        j.depth[i] = meets ? 1 : 0;
        j.stack[i][0] = 0;
    }
}

/// Which children of a node ray i meets before far, as bits, and where it enters their boxes.
inline std::uint32_t meet_children(const Bvh::Node& node, const Journeys& j, int i, float far, float* entry) {
    const float x = j.inverse[0][i], y = j.inverse[1][i], z = j.inverse[2][i];
    const float in_x = j.shift_in[0][i], in_y = j.shift_in[1][i], in_z = j.shift_in[2][i];
    const float out_x = j.shift_out[0][i], out_y = j.shift_out[1][i], out_z = j.shift_out[2][i];
    const Index back_x = j.backward[0][i], back_y = j.backward[1][i], back_z = j.backward[2][i];
    const float *low_x = node.bound[back_x][0], *high_x = node.bound[1 - back_x][0];
    const float *low_y = node.bound[back_y][1], *high_y = node.bound[1 - back_y][1];
    const float *low_z = node.bound[back_z][2], *high_z = node.bound[1 - back_z][2];
    std::uint32_t met = 0;
    for (int c = 0; c < Bvh::width; ++c) {
        const float enter_x = low_x[c] * x - in_x, leave_x = high_x[c] * x - out_x;
        const float enter_y = low_y[c] * y - in_y, leave_y = high_y[c] * y - out_y;
        const float enter_z = low_z[c] * z - in_z, leave_z = high_z[c] * z - out_z;
        float enter = enter_x > 0 ? enter_x : 0, leave = leave_x < far ? leave_x : far;
        enter = enter_y > enter ? enter_y : enter, leave = leave_y < leave ? leave_y : leave;
        enter = enter_z > enter ? enter_z : enter, leave = leave_z < leave ? leave_z : leave;
        entry[c] = enter;
        met |= enter <= leave * (1 + 0x1p-20f) ? 1u << c : 0;
    }
    return met;
}

/// Takes ray i on until it meets boxes of items, which are added to the list, or has come to its end. Returns whether it
/// met any.
inline bool go_on(const Bvh& bvh, Journeys& j, int i, Meetings& meetings) {
    const float far = j.far[i];
    std::uint64_t* const stack = j.stack[i];
    int depth = j.depth[i];
    while (depth > 0) {
        const std::uint64_t top = stack[--depth];
        if (std::bit_cast<float>(std::uint32_t(top >> 32)) > far) continue;
        std::uint32_t at = std::uint32_t(top);
        for (;;) {
            const Bvh::Node& node = bvh.nodes[at];
            alignas(32) float entry[Bvh::width];
            const std::uint32_t met = meet_children(node, j, i, far, entry);
            std::uint32_t items = met & ~node.inner, inner = met & node.inner;
            const auto child = [&] {
                const int c = std::countr_zero(inner);
                inner &= inner - 1;
                return std::uint64_t(std::bit_cast<std::uint32_t>(entry[c])) << 32 | node.child[c];
            };
            if (items != 0) {
                for (; items != 0; items &= items - 1) meetings.add(i, node.child[std::countr_zero(items)]);
                while (inner != 0) stack[depth++] = child();
                j.depth[i] = depth;
                return true;
            }
            if (inner == 0) break;
            std::uint64_t nearest = child();
            const int bottom = depth;
            while (inner != 0) {
                // The nearest is next, the others wait, the nearest of them on top.
                const std::uint64_t other = child();
                std::uint64_t pushed = other > nearest ? other : nearest;
                nearest = other > nearest ? nearest : other;
                int k = depth++;
                for (; k > bottom && stack[k - 1] < pushed; --k) stack[k] = stack[k - 1];
                stack[k] = pushed;
            }
            at = std::uint32_t(nearest);
        }
    }
    j.depth[i] = 0;
    return false;
}

}  // namespace rt
