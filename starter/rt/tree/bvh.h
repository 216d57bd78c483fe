#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>

#include "rt/parts.h"
#include "rt/tree/large_pages.h"

/// How a ray finds the nearest of many shapes without trying them all. Nobody needs this folder for the assignment.
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
};

/// A tree of boxes over the shapes of a scene, in which each node has up to eight children: one loop tests them all.
///
/// Boxes are in single precision, in the tree's own space: (p - center) scale lies between -1 and 1, wherever the scene
/// is and however large. They are rounded; traverse.h widens them.
///
/// Source: Wald, Benthin, Boulos, "Getting Rid of Packets", IRT 2008; Dammertz, Hanika, Keller, "Shallow Bounding
/// Volume Hierarchies for Fast SIMD Ray Tracing of Incoherent Rays", EGSR 2008.
struct Bvh {
    static constexpr int width = 8;
    static constexpr int deepest = 32;  // levels of nodes

    struct alignas(64) Node {
        float bound[3][2][width];    // low and high along each axis; low > high where there is no child
        std::uint32_t child[width];  // the number of a node; of an item. In the order of their centres along the axis
        std::uint32_t axis;
        std::uint32_t leaf;     // all bits set: all children are items; else 0
        std::uint32_t corners;  // of a leaf: which of Bvh::corners are its children's
    };

    /// Of the triangles in a leaf, in the tree's space; all 0 where a child is none.
    struct alignas(32) Corners {
        float at[3][3][width];  // which corner, along an axis, of a child
    };

    Box whole;
    vec3 center{0};
    Real scale = 1;                // a power of two
    LargeVector<Node> nodes;       // the root first
    LargeVector<Corners> corners;  // empty, or of all leaves
};

/// Builds the tree over items 0 to n - 1 by the surface area heuristic, with bins, on all cores. The tree does not
/// depend on how many there are.
///
/// n    below 2^31
/// box  of an item [world]; called from several threads
///
/// Source: Wald, "On Fast Construction of SAH-based Bounding Volume Hierarchies", IRT 2007.
Bvh build_bvh(std::size_t n, const std::function<Box(std::size_t)>& box);

/// Finds the corners of the triangles in the leaves.
///
/// triangle  of an item, or null; called from several threads
void add_corners(Bvh& bvh, const std::function<const Triangle*(std::size_t)>& triangle);

}  // namespace rt
