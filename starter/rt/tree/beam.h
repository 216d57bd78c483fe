#pragma once

#include "rt/tree/traverse.h"

/// The rays of a batch that run side by side, on their way through the tree together.
///
/// All of them look at a node at once: first their common shaft at its eight children, then the rays, as many as a
/// register holds, at each child that the shaft meets. A node that few rays meet is left to each of them.
/// Nobody needs this folder for the assignment.
namespace rt {

/// What the rays have in common, in the tree's space, and the nodes that wait.
///
/// Source: Wald, Slusallek, Benthin, Wagner, "Interactive Rendering with Coherent Ray Tracing", Eurographics 2001;
/// Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", University of Utah,
/// UUCS-06-10, 2006.
struct Beam {
    enum class Runs { up, down, both };

    float start_low[3], start_high[3];      // with margin
    float over_least[3], over_greatest[3];  // 1 / the least and the greatest part of the directions along an axis
    Runs runs[3];                           // along an axis
    unsigned turn[3];                       // as in Journeys, for most rays
    float far;                              // the farthest that any ray still goes
    float spread;                           // of directions

    int left;  // nodes that were left to single rays
    int depth;
    std::uint32_t node[(Bvh::deepest + 1) * Bvh::width];  // the nearest last
    std::uint64_t rays[(Bvh::deepest + 1) * Bvh::width];  // bit i: ray i meets it
};

/// In a tree of more nodes, shapes are so small beside the way between two rays of a batch that these part early.
constexpr std::size_t most_nodes = 1 << 16;

/// Directions may differ by so much, where the largest part of each is 1.
constexpr float widest_beam = 0.75f;

/// The least and the greatest of the numbers of the rays that have an interval left.
inline void range_of(const float* numbers, const Journeys& j, float& low, float& high) {
    Floats least = Floats{} + 1e30f, greatest = -least;
    for (int i = 0; i < lanes; i += wide) {
        const Floats x = load<Floats>(numbers + i), far = load<Floats>(j.far + i);
        least = far >= 0 ? lesser(x, least) : least;
        greatest = far >= 0 ? greater(x, greatest) : greatest;
    }
    greatest = -greatest;
    low = least_of(&least), high = -least_of(&greatest);
}

/// Turns the stacks of the rays that the beam has left: it came to what is near first.
inline void turn_stacks(Journeys& j) {
    for (int i = 0; i < lanes; ++i) std::reverse(j.stack[i] + 1, j.stack[i] + 1 + j.depth[i]);
}

inline void find_far(const Journeys& j, Beam& beam) {
    Floats far = load<Floats>(j.far);
    for (int i = wide; i < lanes; i += wide) far = greater(load<Floats>(j.far + i), far);
    far = -far;
    beam.far = -least_of(&far);
}

/// Begins at the root.
inline void start(const Journeys& j, Beam& beam) {
    float margin, unused;
    range_of(j.margin, j, unused, margin);
    beam.spread = 0;
    for (int a = 0; a < 3; ++a) {
        float slow, fast;
        range_of(j.part[a], j, slow, fast);
        range_of(j.inside[a], j, beam.start_low[a], beam.start_high[a]);
        beam.start_low[a] -= 2 * margin, beam.start_high[a] += 2 * margin;
        beam.over_least[a] = slow != 0 ? 1 / slow : -1e30f, beam.over_greatest[a] = fast != 0 ? 1 / fast : 1e30f;
        beam.runs[a] = slow > 0 ? Beam::Runs::up : fast < 0 ? Beam::Runs::down : Beam::Runs::both;
        beam.turn[a] = slow + fast < 0 ? 0 : 7;
        beam.spread = std::max(beam.spread, fast - slow);
    }
    find_far(j, beam);
    beam.depth = beam.left = 0;
    std::uint64_t rays = 0;
    for (int i = 0; i < lanes; i += wide) rays |= std::uint64_t(not_above(Floats{}, load<Floats>(j.far + i))) << i;
    if (rays) beam.node[beam.depth] = 0, beam.rays[beam.depth++] = rays;
}

/// Which children of a node any ray of the beam may meet.
inline unsigned children_met(const Bvh::Node& node, const Beam& beam) {
    unsigned met = 0;
    for (int c = 0; c < Bvh::width; c += half_wide) {
        FewFloats first = FewFloats{}, last = first + beam.far;
        for (int a = 0; a < 3; ++a) {
            // The beam cannot have passed the low plane before, if it runs up, nor pass the high one after.
            const FewFloats low = (load<FewFloats>(node.bound[a][0] + c) - beam.start_high[a]) * beam.over_greatest[a],
                            high = (load<FewFloats>(node.bound[a][1] + c) - beam.start_low[a]) * beam.over_least[a];
            if (beam.runs[a] == Beam::Runs::up) first = greater(low, first), last = lesser(high, last);
            if (beam.runs[a] == Beam::Runs::down) first = greater(high, first), last = lesser(low, last);
            if (beam.runs[a] == Beam::Runs::both) first = greater(low, greater(high, first));
        }
        met |= not_above(first, last) << c;
    }
    return met;
}

/// Which of the rays meet child c of a node.
inline std::uint64_t rays_that_meet(const Bvh::Node& node, int c, const Journeys& j, std::uint64_t rays) {
    std::uint64_t met = 0;
    for (int i = 0; i < lanes; i += wide) {
        if ((rays >> i & ((std::uint64_t(1) << wide) - 1)) == 0) continue;
        Floats enter = Floats{}, leave = load<Floats>(j.far + i);
        for (int a = 0; a < 3; ++a) {
            const Floats inverse = load<Floats>(j.inverse[a] + i);
            const Floats low = node.bound[a][0][c] * inverse, high = node.bound[a][1][c] * inverse;
            enter = greater(lesser(low, high) - load<Floats>(j.shift_in[a] + i), enter);
            leave = lesser(greater(low, high) - load<Floats>(j.shift_out[a] + i), leave);
        }
        met |= std::uint64_t(not_above(enter, leave)) << i;
    }
    return met & rays;
}

/// Takes the nearest node that waits.
///
/// alive  bit i: ray i still looks for something
/// few    so many rays, or fewer, take the node onto their own stacks
/// sieve  (leaf, child, rays): those of the rays that may meet the item itself
template <class Sieve>
void step(const Bvh::Node* nodes, Journeys& j, std::uint64_t alive, int few, Sieve sieve, Beam& beam,
          Meetings& meetings) {
    const Bvh::Node& node = nodes[beam.node[--beam.depth]];
    const std::uint64_t rays = beam.rays[beam.depth] & alive;
    if (rays == 0) return;
    if (std::popcount(rays) <= few && beam.left < Journeys::room) {
        ++beam.left;
        for (std::uint64_t left = rays; left; left &= left - 1) {
            const int i = std::countr_zero(left);
            j.stack[i][++j.depth[i]] = beam.node[beam.depth];
        }
        return;
    }
    const unsigned turn = beam.turn[node.axis];
    const unsigned children = children_met(node, beam);
    for (unsigned k = 0; k < Bvh::width; ++k) {
        const unsigned c = k ^ turn;
        if ((children >> c & 1) == 0) continue;
        std::uint64_t met = rays_that_meet(node, int(c), j, rays);
        if (met == 0) continue;
        if (!node.leaf) {
            fetch(nodes[node.child[c]]);
            beam.node[beam.depth] = node.child[c], beam.rays[beam.depth++] = met;
            continue;
        }
        for (met = sieve(node, c, met); met; met &= met - 1)
            meetings.pair[meetings.count++] = std::uint64_t(std::countr_zero(met)) << 32 | node.child[c];
    }
}

}  // namespace rt
