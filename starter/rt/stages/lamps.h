#pragma once

#include "rt/lamps/solid_angle.h"
#include "rt/stages/stages.h"

/// The lamps with extent of the direct stage: which one each lane is lit by, and how points of it are found.
namespace rt {

using Kind = Emitter::Kind;

/// A lamp for each lane, chosen with its probability, 0 where it is of another kind; or one for all lanes.
///
/// In arrays of numbers, for loops that copy structures do not vectorise. What a kind lacks is finite, and of no meaning.
template <Kind kind, int count>
struct alignas(64) Lamps {
    Real x[count]{}, y[count]{}, z[count]{};     // centre
    Real ux[count]{}, uy[count]{}, uz[count]{};  // half edge of a quad, or normal of a disc
    Real vx[count]{}, vy[count]{}, vz[count]{}, radius[count]{};
    Real r[count]{}, g[count]{}, b[count]{}, probability[count]{};

    void set(int i, const Emitter& lamp, Real chosen) {
        if (lamp.kind != kind) return;
        const vec3 c = kind == Kind::quad ? lamp.quad.center : kind == Kind::disc ? lamp.disc.center : lamp.sphere.center;
        const vec3 u = kind == Kind::quad ? lamp.quad.u : lamp.disc.normal, v = lamp.quad.v;
        x[i] = c.x, y[i] = c.y, z[i] = c.z, ux[i] = u.x, uy[i] = u.y, uz[i] = u.z, vx[i] = v.x, vy[i] = v.y, vz[i] = v.z;
        radius[i] = kind == Kind::disc ? lamp.disc.radius : lamp.sphere.radius;
        r[i] = lamp.radiance.x, g[i] = lamp.radiance.y, b[i] = lamp.radiance.z, probability[i] = chosen;
    }
    Emitter at(int lane) const {
        const int i = index(lane);
        const vec3 c(x[i], y[i], z[i]), u(ux[i], uy[i], uz[i]), v(vx[i], vy[i], vz[i]);
        return {kind, {c, u, v}, {c, u, radius[i]}, {c, radius[i]}, radiance(lane)};
    }
    Color radiance(int lane) const { return {r[index(lane)], g[index(lane)], b[index(lane)]}; }
    Real chosen(int lane) const { return probability[index(lane)]; }

private:
    static int index(int lane) { return count == 1 ? 0 : lane; }
};

/// How points of a light are found.
enum class By { fragment, solid_angle };

template <By by>
[[gnu::always_inline]] inline LightSample sample_light(const Emitter& lamp, vec3 p, vec2 u) {
    if constexpr (by == By::fragment) {
        return light_sample(lamp, p, u);  // straight away: the compiler does not vectorise a copy
    } else {
        const SeenQuad seen = seen_from(lamp.quad, p);
        const LightSample narrow = light_sample(lamp, p, u), wide = sample_by_angle(seen, u);
        const bool w = seen.is_wide();
        return {{w ? wide.direction.x : narrow.direction.x, w ? wide.direction.y : narrow.direction.y,
                 w ? wide.direction.z : narrow.direction.z},
                w ? wide.distance : narrow.distance, w ? wide.density : narrow.density};
    }
}

/// Calls f with lamps of one kind, and with how points of them are found.
template <Kind kind, int count, class F>
void with_way(const World& world, const Lamps<kind, count>& lamps, F f) {
    if constexpr (kind == Kind::quad)
        if (world.plan.solid_angle) return f(lamps, std::integral_constant<By, By::solid_angle>{});
    f(lamps, std::integral_constant<By, By::fragment>{});
}

/// Calls f with one lamp for all lanes.
template <class F>
void with_lamp(const World& world, const Emitter& lamp, F f) {
    const auto of_kind = [&]<Kind kind>(std::integral_constant<Kind, kind>) {
        Lamps<kind, 1> lamps;
        lamps.set(0, lamp, 1);
        with_way(world, lamps, f);
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
    if (any[int(Kind::quad)]) with_way(world, quads, f);
    if (any[int(Kind::disc)]) with_way(world, discs, f);
    if (any[int(Kind::sphere)]) with_way(world, spheres, f);
}

}  // namespace rt
