#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rt/ray.h"

namespace rt {

/// An axis-parallel box; empty until a point is put in.
struct Box {
    vec3 low{inf}, high{-inf};

    void include(vec3 p) {
        low = {p.x < low.x ? p.x : low.x, p.y < low.y ? p.y : low.y, p.z < low.z ? p.z : low.z};
        high = {p.x > high.x ? p.x : high.x, p.y > high.y ? p.y : high.y, p.z > high.z ? p.z : high.z};
    }
    void include(const Box& b) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
    vec3 center() const { return 0.5 * low + 0.5 * high; }
    /// Half the surface; 0 for an empty box.
    Real half_area() const {
        const vec3 d = high - low;
        return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
    }
};

/// A binary tree of boxes over the shapes of a scene.
struct Bvh {
    struct Node {
        Box box;
        std::uint32_t first;  // inner node: its right child (the left one is next to it); leaf: its first item
        std::uint32_t count;  // of the leaf's items; 0: an inner node
        std::uint32_t axis;   // along which an inner node is split
    };
    std::vector<Node> nodes;
    std::vector<std::uint32_t> items;  // numbers of boxes, leaf by leaf
};

/// Builds the tree by the surface area heuristic, with bins.
///
/// Source: Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", IRT 2007.
Bvh build_bvh(const std::vector<Box>& boxes);

/// Calls leaf(item, far) for each item whose box the ray may meet before far, near boxes first. leaf returns the new
/// far; the search ends when it is not above ray.near.
///
/// All boxes are widened by a few roundings of the largest numbers that take part in finding a hit, so that none is
/// missed that the leaf finds; and a NaN (0/0: the ray runs in a face) leaves the interval as it is.
///
/// Source: Kay and Kajiya, "Ray Tracing Complex Scenes", SIGGRAPH 1986; Ize, "Robust BVH Ray Traversal", JCGT 2(2),
/// 2013.
template <class Leaf>
void traverse(const Bvh& bvh, const Ray& ray, Leaf leaf) {
    if (bvh.nodes.empty()) return;
    const vec3 over = 1.0 / ray.direction;
    const bool backward[3] = {over.x < 0, over.y < 0, over.z < 0};
    const Box& whole = bvh.nodes[0].box;
    const Real margin = 32 * roundoff * (largest(ray.origin) + std::max(largest(whole.low), largest(whole.high)));
    const vec3 to_low = ray.origin + margin, to_high = ray.origin - margin;
    // Grazing, a hit's own distance is less certain: a box is left out only where it is farther by more than that.
    const Real slack = 0x1p20 * margin / largest(ray.direction);
    Real far = ray.far;
    std::uint32_t stack[128];
    int depth = 0;
    std::uint32_t at = 0;
    for (;;) {
        const Bvh::Node& node = bvh.nodes[at];
        Real t0 = ray.near, t1 = far + slack;
        for (int a = 0; a < 3; ++a) {
            const Real low = (node.box.low[a] - to_low[a]) * over[a], high = (node.box.high[a] - to_high[a]) * over[a];
            const Real enter = backward[a] ? high : low, leave = backward[a] ? low : high;
            t0 = enter > t0 ? enter : t0;
            t1 = leave < t1 ? leave : t1;
        }
        if (t0 <= t1) {
            if (node.count == 0) {
                const std::uint32_t left = at + 1, right = node.first;
                stack[depth++] = backward[node.axis] ? left : right;
                at = backward[node.axis] ? right : left;
                continue;
            }
            for (std::uint32_t i = 0; i < node.count; ++i) far = leaf(bvh.items[node.first + i], far);
            if (!(far > ray.near)) return;
        }
        if (depth == 0) return;
        at = stack[--depth];
    }
}

}  // namespace rt
