#pragma once

#include <cstddef>
#include <vector>

#include "rt/scene.h"

/// Better samples of lamps: which one, by solid angle, weighed against lobes. Nobody needs this folder for the
/// assignment.
namespace rt {

/// Chooses one of many lamps for a point, the more likely the more light it may send there: as bright lamps that are
/// near do. A binary tree whose leaves are the lamps: the choice takes a logarithm of their number.
///
/// Source: Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree Splitting", Proc. ACM
/// Comput. Graph. Interact. Tech. 1(2), 2018, without their bounds of angles.
class LampTree {
public:
    LampTree() = default;
    explicit LampTree(const std::vector<Emitter>& lamps);  // at least one

    struct Choice {
        std::size_t lamp;
        Real probability;  // > 0
    };

    /// p  point of a surface [world]
    /// u  random, 0 <= u < 1
    Choice choose(vec3 p, Real u) const;

    /// The probability with which a lamp is chosen for a point.
    Real probability(std::size_t lamp, vec3 p) const;

private:
    /// A sphere about all lamps below, and what they send out.
    struct Node {
        vec3 center{0};
        Real radius = 0, power = 0;
    };

    Real first_share(std::size_t node, vec3 p) const;

    std::vector<Node> nodes_;  // node k has the children 2k and 2k + 1; lamps from leaves_ on, then nodes without any
    std::vector<std::size_t> lamp_, leaf_;  // of a leaf, and of a lamp
    std::size_t leaves_ = 1;
};

}  // namespace rt
