#include "rt/lamps/lamp_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <span>

namespace rt {
namespace {

/// Of a sphere about the lamp.
Real radius(const Emitter& lamp) {
    return lamp.kind == Emitter::Kind::quad   ? std::sqrt(dot(lamp.quad.u, lamp.quad.u) + dot(lamp.quad.v, lamp.quad.v))
           : lamp.kind == Emitter::Kind::disc ? lamp.disc.radius
                                              : lamp.sphere.radius;
}

/// The intensity in the direction in which a lamp shines most, summed over the channels [W/sr].
Real power(const Emitter& lamp) { return area(lamp) * (lamp.radiance.x + lamp.radiance.y + lamp.radiance.z); }

/// Divides lamps between the two halves of a node's leaves, along the axis on which they are furthest apart.
void sort(const std::vector<Emitter>& lamps, std::span<std::size_t> order, std::size_t leaves) {
    if (order.size() < 2) return;
    vec3 low(inf), high(-inf);
    for (const std::size_t i : order) low = glm::min(low, center(lamps[i])), high = glm::max(high, center(lamps[i]));
    const vec3 wide = high - low;
    const int axis = wide.x >= wide.y && wide.x >= wide.z ? 0 : wide.y >= wide.z ? 1 : 2;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return center(lamps[i])[axis] < center(lamps[j])[axis]; });
    const std::size_t first = std::min(order.size(), leaves / 2);
    sort(lamps, order.first(first), leaves / 2);
    sort(lamps, order.subspan(first), leaves / 2);
}

}  // namespace

LampTree::LampTree(const std::vector<Emitter>& lamps)
    : nodes_(2 * std::bit_ceil(lamps.size())),
      lamp_(lamps.size()),
      leaf_(lamps.size()),
      leaves_(std::bit_ceil(lamps.size())) {
    std::iota(lamp_.begin(), lamp_.end(), 0);
    sort(lamps, lamp_, leaves_);
    Real most = 0;
    for (const Emitter& lamp : lamps) most = std::max(most, power(lamp));
    for (std::size_t leaf = 0; leaf < lamps.size(); ++leaf) {
        const Emitter& lamp = lamps[lamp_[leaf]];
        nodes_[leaves_ + leaf] = {center(lamp), radius(lamp), power(lamp) / most};
        leaf_[lamp_[leaf]] = leaf;
    }
    for (std::size_t k = leaves_ - 1; k > 0; --k) {
        const Node &a = nodes_[2 * k], &b = nodes_[2 * k + 1];
        nodes_[k] = a;
        if (b.power > 0)
            nodes_[k] = {(a.center + b.center) * 0.5, length(b.center - a.center) / 2 + std::max(a.radius, b.radius),
                         a.power + b.power};
    }
}

/// The probability of the first child of a node.
Real LampTree::first_share(std::size_t node, vec3 p) const {
    // over the square of the distance, but for what is inside the sphere
    const auto sends = [p](const Node& n) {
        const vec3 to = n.center - p;
        return n.power / std::max(dot(to, to), sqr(n.radius));
    };
    const Real first = sends(nodes_[2 * node]), second = sends(nodes_[2 * node + 1]);
    return nodes_[2 * node + 1].power == 0 ? 1 : first / (first + second);
}

LampTree::Choice LampTree::choose(vec3 p, Real u) const {
    std::size_t node = 1;
    Real probability = 1;
    while (node < leaves_) {
        const Real first = first_share(node, p);
        const bool second = u >= first;
        const Real share = second ? 1 - first : first;
        u = std::min((second ? u - first : u) / share, below_one);
        probability *= share;
        node = 2 * node + second;
    }
    return {lamp_[node - leaves_], probability};
}

Real LampTree::probability(std::size_t lamp, vec3 p) const {
    Real probability = 1;
    for (std::size_t node = leaves_ + leaf_[lamp]; node > 1; node /= 2) {
        const Real first = first_share(node / 2, p);
        probability *= node % 2 == 1 ? 1 - first : first;
    }
    return probability;
}

}  // namespace rt
