#pragma once

#include "rt/stages/stages.h"

/// The lamps with extent of the direct stage: which one each lane is lit by.
namespace rt {

using Kind = Emitter::Kind;

/// A lamp for each lane, chosen with its probability, 0 where it is of another kind; or one for all lanes. What a kind
/// lacks is finite, and of no meaning.
template <Kind kind, int count>
struct Lamps {
    Vectors<count> center{}, u{}, v{};  // u: half edge of a quad, or normal of a disc
    Real radius[count]{}, probability[count]{};
    Vectors<count> radiance{};

    void set(int i, const Emitter& lamp, Real chosen) {
        if (lamp.kind != kind) return;
        center.set(i, rt::center(lamp));
        u.set(i, kind == Kind::quad ? lamp.quad.u : lamp.disc.normal), v.set(i, lamp.quad.v);
        radius[i] = kind == Kind::disc ? lamp.disc.radius : lamp.sphere.radius;
        radiance.set(i, lamp.radiance), probability[i] = chosen;
    }
    Emitter at(int lane) const {
        const int i = index(lane);
        const vec3 c = center.at(i), half = u.at(i);
        return {kind, {c, half, v.at(i)}, {c, half, radius[i]}, {c, radius[i]}, radiance.at(i)};
    }
    Real chosen(int lane) const { return probability[index(lane)]; }

private:
    static int index(int lane) { return count == 1 ? 0 : lane; }
};

/// Calls f with lamps of one kind, and with whether points of them are found by solid angle.
template <Kind kind, int count, class F>
void with_angle(const World& world, const Lamps<kind, count>& lamps, F f) {
    if constexpr (kind == Kind::quad)
        if (world.plan.solid_angle) return f(lamps, std::true_type{});
    f(lamps, std::false_type{});
}

/// Calls f with one lamp for all lanes.
template <class F>
void with_lamp(const World& world, const Emitter& lamp, F f) {
    const auto of_kind = [&]<Kind kind>(std::integral_constant<Kind, kind>) {
        Lamps<kind, 1> lamps;
        lamps.set(0, lamp, 1);
        with_angle(world, lamps, f);
    };
    if (lamp.kind == Kind::quad) of_kind(std::integral_constant<Kind, Kind::quad>{});
    if (lamp.kind == Kind::disc) of_kind(std::integral_constant<Kind, Kind::disc>{});
    if (lamp.kind == Kind::sphere) of_kind(std::integral_constant<Kind, Kind::sphere>{});
}

/// Chooses a lamp for each lane that is on a surface, and calls f for each kind.
///
/// u  of the choice
template <class F>
void with_chosen_lamps(const World& world, const Surfaces& s, int count, const Numbers& u, F f) {
    Lamps<Kind::quad, lanes> quads;
    Lamps<Kind::disc, lanes> discs;
    Lamps<Kind::sphere, lanes> spheres;
    bool any[3] = {};
    for (int i = 0; i < count; ++i) {
        if (s.material[i] == nothing) continue;
        const LampTree::Choice choice = world.lamp_tree.choose(s.hit(i).point, u.x[i]);
        const Emitter& lamp = world.emitters[choice.lamp];
        quads.set(i, lamp, choice.probability), discs.set(i, lamp, choice.probability);
        spheres.set(i, lamp, choice.probability);
        any[int(lamp.kind)] = true;
    }
    if (any[int(Kind::quad)]) with_angle(world, quads, f);
    if (any[int(Kind::disc)]) with_angle(world, discs, f);
    if (any[int(Kind::sphere)]) with_angle(world, spheres, f);
}

}  // namespace rt
