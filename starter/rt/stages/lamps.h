#pragma once

#include <algorithm>

#include "rt/fragments.h"
#include "rt/lamps/solid_angle.h"
#include "rt/stages/stages.h"

/// The lamps with extent, for the stages that look for them: which one each lane is lit by, and with which probability.
/// Nobody needs this file for the assignment.
namespace rt {

struct ChosenLamp {
    Emitter lamp;
    Real probability;  // with which this lamp was chosen: 1, where all are sampled
    bool by_angle;     // a quad whose points are taken by solid angle
};

/// Adapts a point of a lamp to how lamp and point are chosen: its density becomes that of both choices; by solid angle,
/// it is another point. Not a function that returns it: structures that pass through one more stay structures, and the
/// loops about them scalar.
///
/// p  that is lit [world]
[[gnu::always_inline]] inline void adapt(LightSample& sample, const ChosenLamp& chosen, vec3 p, vec2 u) {
    if (chosen.by_angle) sample = by_angle_or(sample, chosen.lamp.quad, p, u);
    sample.density *= chosen.probability;
}

using Kind = Emitter::Kind;

/// A lamp of one kind for each lane, of probability 0 where it is of another; or one for all lanes. What a kind lacks
/// is finite, and of no meaning. The compiler knows kind and by_angle, and makes loops for each.
template <Kind kind, bool by_angle, int count>
struct Lamps {
    Vectors<count> center{}, u{}, v{};  // u: half edge of a quad, or normal of a disc
    Real radius[count]{}, probability[count]{};
    Vectors<count> radiance{};

    void set(int i, const Emitter& lamp, Real chosen) {
        center.set(i, rt::center(lamp));
        u.set(i, kind == Kind::quad ? lamp.quad.u : lamp.disc.normal), v.set(i, lamp.quad.v);
        radius[i] = kind == Kind::disc ? lamp.disc.radius : lamp.sphere.radius;
        radiance.set(i, lamp.radiance), probability[i] = chosen;
    }
    [[gnu::always_inline]] ChosenLamp at(int lane) const {
        const int i = index(lane);
        const vec3 c = center.at(i), half = u.at(i);
        return {
            {kind, {c, half, v.at(i)}, {c, half, radius[i]}, {c, radius[i]}, radiance.at(i)}, chosen(lane), by_angle};
    }
    Real chosen(int lane) const { return probability[index(lane)]; }

private:
    static int index(int lane) { return count == 1 ? 0 : lane; }
};

/// The lamps that lanes are lit by; null: none.
template <int count>
struct Choices {
    const Emitter* lamp[count]{};
    Real probability[count]{};
};

template <Kind kind, bool by_angle, int count, class F>
void with_kind(const Choices<count>& choices, F f) {
    const auto is_of_kind = [](const Emitter* lamp) { return lamp && lamp->kind == kind; };
    if (std::none_of(choices.lamp, choices.lamp + count, is_of_kind)) return;
    Lamps<kind, by_angle, count> lamps;
    for (int i = 0; i < count; ++i)
        if (is_of_kind(choices.lamp[i])) lamps.set(i, *choices.lamp[i], choices.probability[i]);
    f(lamps);
}

/// Calls f with those of each kind that there is.
template <int count, class F>
void with_each_kind(const World& world, const Choices<count>& choices, F f) {
    world.plan.solid_angle ? with_kind<Kind::quad, true>(choices, f) : with_kind<Kind::quad, false>(choices, f);
    with_kind<Kind::disc, false>(choices, f);
    with_kind<Kind::sphere, false>(choices, f);
}

/// Calls f(lamps, u) with each lamp, or with those that are chosen for the lanes, one for each; u: numbers for a point
/// of the lamp.
///
/// lit    the points that are lit: those with a material
/// drawn  for how many lanes f wants numbers
template <class F>
void for_each_lamp(const Wave& wave, const Surfaces& lit, int drawn, F f) {
    const World& world = wave.world;
    Numbers u, choice;
    const auto with_numbers = [&](const auto& lamps) { f(lamps, u); };
    if (world.plan.one_lamp) {
        wave.draw_2d(light_dimension, drawn, u);
        wave.draw_1d(light_dimension + 1, drawn, choice);
        Choices<lanes> choices;
        for (int i = 0; i < wave.batch.count; ++i) {
            if (lit.material[i] == nothing) continue;
            const LampTree::Choice chosen = world.lamp_tree.choose(lit.point.at(i), choice.x[i]);
            choices.lamp[i] = &world.emitters[chosen.lamp], choices.probability[i] = chosen.probability;
        }
        return with_each_kind(world, choices, with_numbers);
    }
    for (std::size_t l = 0; l < world.emitters.size(); ++l) {
        wave.draw_2d(light_dimension + int(l), drawn, u);
        with_each_kind<1>(world, {{&world.emitters[l]}, {1}}, with_numbers);
    }
}

}  // namespace rt
