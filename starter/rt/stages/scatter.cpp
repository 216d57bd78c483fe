#include "rt/lamps/importance.h"
#include "rt/stages/stages.h"

namespace rt {
namespace {

/// How a path goes on from a surface.
enum class Way { mirror, glossy, glass, translucent, bounce };
constexpr int ways = 5;

/// The lanes that go on in one way, and what each carries on.
struct alignas(64) Leaving {
    int count;
    Index lane[lanes];
    Colors weight;

    void add(int i, Color w) { lane[count] = i, weight.set(count++, w); }
};

using AllLeaving = std::array<Leaving, ways>;

Leaving& of(AllLeaving& all, Way way) { return all[std::size_t(way)]; }

/// Decides how lanes from `begin` to `end` go on. Where there are several ways, one is chosen with a probability in proportion to what
/// it carries; or, if the plan says so, mirror and glass are both followed.
void choose(const World& world, Pattern pattern, Dimension choice, const Batch& b, const Surfaces& s, int begin, int end,
            AllLeaving& leaving) {
    const RenderPlan& plan = world.plan;
    Numbers numbers;
    bool drawn = false;
    for (Leaving& way : leaving) way.count = 0;
    for (int i = begin; i < end; ++i) {
        if (s.material[i] == nothing) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        const Color weight = b.weight(i);
        const Way mirror = m.exponent == inf ? Way::mirror : Way::glossy,
                  glass = m.exponent == inf ? Way::glass : Way::translucent;

        // What each way on would carry.
        const bool deeper = (plan.specular || plan.lobe) && b.depth[i] < world.scene.depth;
        Outgoing out{Color(1), Color(0), Color(0)};
        if (deeper) {
            out = outgoing(m, b, s, i);
        }
        const Real mirror_share = deeper ? largest(out.mirror) : 0, glass_share = deeper ? largest(out.glass) : 0;
        const Real bounce_share = b.bounce[i] < world.scene.bounces ? largest(out.local * m.albedo) : 0;
        const Real sum = mirror_share + glass_share + bounce_share;
        if (sum == 0) continue;

        if (plan.split) {
            if (mirror_share > 0) of(leaving, mirror).add(i, weight * out.mirror);
            if (glass_share > 0) of(leaving, glass).add(i, weight * out.glass);
            continue;
        }
        const bool alone = mirror_share == sum || glass_share == sum || bounce_share == sum;
        if (!alone && !drawn) draw_1d(pattern, choice, b.key, b.sample, b.count, numbers), drawn = true;
        const Real u = alone ? 0 : sum * numbers.x[i];
        if (u < mirror_share)
            of(leaving, mirror).add(i, weight * out.mirror * (sum / mirror_share));
        else if (u < mirror_share + glass_share)
            of(leaving, glass).add(i, weight * out.glass * (sum / glass_share));
        else
            of(leaving, Way::bounce).add(i, weight * out.local * (sum / bounce_share));
    }
}

/// Every lane with an albedo bounces, if bounces are the only way on.
void bounce_all(const World& world, const Batch& b, const Surfaces& s, Leaving& leaving) {
    const Material* materials = world.scene.materials.data();
    leaving.count = 0;
    for (int i = 0; i < b.count; ++i) {
        const bool on = s.material[i] != nothing && b.bounce[i] < world.scene.bounces &&
                        materials[s.material[i]].albedo != Color(0);
        leaving.lane[leaving.count] = i;
        leaving.weight.set(leaving.count, b.weight(i));
        leaving.count += on;
    }
}

/// What decides where lanes go on, side by side.
struct alignas(64) Crossing {
    Real dx[lanes], dy[lanes], dz[lanes];  // direction of travel
    Real nx[lanes], ny[lanes], nz[lanes];  // shading normal
    Real px[lanes], py[lanes], pz[lanes], gx[lanes], gy[lanes], gz[lanes], error[lanes];
    Real exponent[lanes], ior_from[lanes], ior_to[lanes];
    Real albedo_r[lanes], albedo_g[lanes], albedo_b[lanes];
    Bits key[lanes];
    int sample[lanes];

    Hit hit(int k) const { return {{px[k], py[k], pz[k]}, {gx[k], gy[k], gz[k]}, error[k]}; }
};

/// Collects lanes that leave in one way, and copies what stays with a path into its new lanes, from `first` on.
template <Way way>
void collect(const World& world, const Batch& b, const Surfaces& s, const Index* leaving, int count, Crossing& c,
             Batch& to, int first) {
    constexpr bool specular = way == Way::mirror || way == Way::glass, bounces = way == Way::bounce;
    constexpr bool enters = way == Way::glass || way == Way::translucent;
    constexpr Event event = bounces ? Event::diffuse : specular ? Event::specular : Event::lobe;
    const bool media = world.plan.medium, through = world.plan.through;
    for (int k = 0; k < count; ++k) {
        const Index i = leaving[k];
        const int j = first + k;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        const bool behind = s.behind[i] != 0;
        c.dx[k] = b.dx[i], c.dy[k] = b.dy[i], c.dz[k] = b.dz[i];
        c.nx[k] = s.nx[i], c.ny[k] = s.ny[i], c.nz[k] = s.nz[i];
        c.px[k] = s.px[i], c.py[k] = s.py[i], c.pz[k] = s.pz[i];
        c.gx[k] = s.gx[i], c.gy[k] = s.gy[i], c.gz[k] = s.gz[i], c.error[k] = s.error[i];
        if constexpr (!bounces) c.exponent[k] = m.exponent;
        if constexpr (enters) c.ior_from[k] = behind ? m.ior : 1, c.ior_to[k] = behind ? 1 : m.ior;
        if constexpr (bounces) c.albedo_r[k] = m.albedo.x, c.albedo_g[k] = m.albedo.y, c.albedo_b[k] = m.albedo.z;
        // Mirror and glass may both be followed: their random numbers must not be the same.
        to.key[j] = enters ? combine(b.key[i], 1) : b.key[i];
        c.key[k] = b.key[i];
        to.sample[j] = c.sample[k] = b.sample[i];
        to.time[j] = b.time[i];
        to.slot[j] = b.slot[i];
        // Where shadow rays go through, they have gathered what a diffuse ray finds behind: it still is one.
        const bool goes_on = enters && through && b.event[i] == Index(Event::diffuse) && goes_straight_through(m);
        to.event[j] = goes_on ? b.event[i] : Index(event);
        to.depth[j] = b.depth[i] + !bounces;
        to.bounce[j] = b.bounce[i] + bounces;
        if constexpr (way == Way::glossy || way == Way::translucent) to.density[j] = 0;
        to.inside[j] = enters && media ? world.regions.crossed(b.inside[i], b.shape[i], behind) : b.inside[i];
    }
}

/// Where a lane goes, and with which share of its light.
template <Way way>
Scattered direction_of(const Crossing& c, int k, vec2 u) {
    const vec3 d{c.dx[k], c.dy[k], c.dz[k]}, n{c.nx[k], c.ny[k], c.nz[k]};
    if constexpr (way == Way::mirror) return {mirror_direction(d, n), Color(1)};
    if constexpr (way == Way::glossy) return glossy_reflection(d, n, c.exponent[k], u);
    if constexpr (way == Way::glass) return {refracted_direction(d, n, c.ior_from[k], c.ior_to[k]), Color(1)};
    if constexpr (way == Way::translucent)
        return translucency(d, n, c.ior_from[k], c.ior_to[k], c.exponent[k], u);
    return color_bleeding(n, {c.albedo_r[k], c.albedo_g[k], c.albedo_b[k]}, u);
}

/// Writes the rays that leave in one way, and their weights, into lanes of a batch, from `first` on.
template <Way way>
void send(const Numbers& u, const Crossing& c, const Leaving& leaving, int begin, int count, Batch& to,
          int first) {
#pragma GCC ivdep
    for (int k = 0; k < count; ++k) {
        const Scattered scattered = direction_of<way>(c, k, u.at(k));
        to.set_ray(first + k, spawn_ray(c.hit(k), scattered.direction));
        to.set_weight(first + k, leaving.weight.at(begin + k) * scattered.weight);
    }
}

/// With which density each lane of a glossy lobe was taken, where that is weighed against lamps.
void note_densities(const Crossing& c, int count, Batch& to, int first) {
    for (int k = 0; k < count; ++k) {
        const int j = first + k;
        to.density[j] = lobe_density(c.exponent[k], {to.dx[j], to.dy[j], to.dz[j]}, {c.nx[k], c.ny[k], c.nz[k]},
                                     {-c.dx[k], -c.dy[k], -c.dz[k]});
    }
}

/// Brings rays back to the right side of their surfaces, to which the interpolated normals of a mesh may not send them. What
/// a lobe sends there counts in full: no sample of a lamp would have found it.
template <Way way>
void bring_back(const Crossing& c, int count, Batch& to, int first) {
    for (int k = 0; k < count; ++k) {
        const int j = first + k;
        const Hit hit = c.hit(k);
        const vec3 way_on{to.dx[j], to.dy[j], to.dz[j]};
        const bool bent = vec3(c.nx[k], c.ny[k], c.nz[k]) != hit.normal;
        if (!bent || !is_astray(way_on, hit.normal, way == Way::glass || way == Way::translucent)) continue;
        to.set_ray(j, spawn_ray(hit, turned(way_on, hit.normal)));
        if constexpr (way == Way::glossy) to.density[j] = 0;
    }
}

/// Takes out lanes, from `first` on, that carry nothing or have nowhere to go.
void close_ranks(Batch& b, int first) {
    int kept = first;
    for (int j = first; j < b.count; ++j) {
        const bool dead = b.weight(j) == Color(0) || vec3(b.dx[j], b.dy[j], b.dz[j]) == vec3(0);
        if (dead) continue;
        if (kept != j) b.copy_lane(j, kept);
        ++kept;
    }
    b.count = kept;
}

template <Way way>
[[gnu::noinline]] void follow(const World& world, Pattern pattern, Dimension dimension, const Batch& b, const Surfaces& s, const Leaving& leaving,
            Queue& next, Chunk& chunk) {
    constexpr RayKind kind = way == Way::mirror  ? RayKind::mirror
                             : way == Way::glass ? RayKind::glass
                             : way == Way::bounce ? RayKind::bounce
                                                  : RayKind::lobe;
    constexpr bool specular = way == Way::mirror || way == Way::glass;
    Crossing crossing;
    Numbers u;
    for (int k = 0; k < leaving.count;) {
        Batch& to = next.open();
        const int first = to.count, taken = std::min(leaving.count - k, lanes - first);
        collect<way>(world, b, s, leaving.lane + k, taken, crossing, to, first);
        if constexpr (!specular) draw_2d(pattern, dimension, crossing.key, crossing.sample, taken, u);
        send<way>(u, crossing, leaving, k, taken, to, first);
        if (way == Way::glossy && world.plan.weigh) note_densities(crossing, taken, to, first);
        if (way != Way::bounce && world.plan.smooth) bring_back<way>(crossing, taken, to, first);
        to.count = first + taken;
        close_ranks(to, first);
        chunk.rays[int(kind)] += std::uint64_t(to.count - first);
        k += taken;
    }
}

}  // namespace

void scatter_stage(const World& world, Pattern pattern, int wave, const Batch& b, const Surfaces& s,
                   Queue& next, Chunk& chunk) {
    const RenderPlan& plan = world.plan;
    if (!plan.specular && !plan.lobe && !plan.bounce) return;
    const Dimension choice = wave_dimension(world, wave, choice_dimension, pattern.n),
                    lobe = wave_dimension(world, wave, lobe_dimension, pattern.n);
    AllLeaving leaving;
    const auto follow_way = [&](auto way) {
        follow<way()>(world, pattern, lobe, b, s, of(leaving, way()), next, chunk);
    };
    const std::integral_constant<Way, Way::mirror> mirror;
    const std::integral_constant<Way, Way::glass> glass;
    const std::integral_constant<Way, Way::bounce> bounce;
    if (plan.split) {
        // Two paths may add to one sample: lane by lane, so that the order of the sum does not depend on what else is in
        // the batch.
        for (int i = 0; i < b.count; ++i) {
            choose(world, pattern, choice, b, s, i, i + 1, leaving);
            follow_way(mirror);
            follow_way(glass);
        }
    } else if (!plan.specular && !plan.lobe) {
        bounce_all(world, b, s, of(leaving, Way::bounce));
        follow_way(bounce);
    } else {
        choose(world, pattern, choice, b, s, 0, b.count, leaving);
        follow_way(mirror);
        follow_way(std::integral_constant<Way, Way::glossy>{});
        follow_way(glass);
        follow_way(std::integral_constant<Way, Way::translucent>{});
        follow_way(bounce);
    }
}

}  // namespace rt
