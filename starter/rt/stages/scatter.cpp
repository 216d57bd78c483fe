#include "rt/lamps/importance.h"
#include "rt/stages/outgoing.h"
#include "rt/stages/stages.h"

/// How paths go on from the surfaces that they meet. The next ray carries
///
///     weight of the path x whitted's weight of the way / probability of the way x weight of the fragment's direction
///
/// Where several ways lead on, one is chosen, with a probability in proportion to what it would carry; mirror and
/// glass, if there is nothing else, are both followed. In this file, in this order:
///
///     direction_of   one lane: where a way leads, by its fragment
///     shares_of      one lane: what each way would carry
///     choose_...     which lanes go which way
///     collect, send  the lanes that go one way, side by side, and their new rays
///     append         those that carry anything, with what stays with their paths
///     scatter_stage  way after way
namespace rt {
namespace {

/// Loops over some of the lanes take a multiple of so many, the last one more than once: vectors have no rest.
constexpr int whole = 8;

/// What decides where lanes go on, side by side.
struct Crossing {
    Vectors<> direction, normal;  // of travel; shading
    Vectors<> point, flat;
    Real error[lanes];
    Real exponent[lanes], ior_from[lanes], ior_to[lanes];
    Colors albedo;
    Colors weight;
    Bits key[lanes];
    int sample[lanes];

    Hit hit(int k) const { return {point.at(k), flat.at(k), error[k]}; }
};

/// Where a lane goes, and with which share of its light.
template <WayOn way>
Scattered direction_of(const Crossing& c, int k, vec2 u) {
    const vec3 d = c.direction.at(k), n = c.normal.at(k);
    if constexpr (way == WayOn::mirror) return {mirror_direction(d, n), Color(1)};
    if constexpr (way == WayOn::glossy) return glossy_reflection(d, n, c.exponent[k], u);
    if constexpr (way == WayOn::glass) return {refracted_direction(d, n, c.ior_from[k], c.ior_to[k]), Color(1)};
    if constexpr (way == WayOn::translucent) return translucency(d, n, c.ior_from[k], c.ior_to[k], c.exponent[k], u);
    return color_bleeding(n, c.albedo.at(k), u);
}

/// What each way on from the surface of a lane would carry.
struct Shares {
    Outgoing weights{Color(1), Color(0), Color(0)};
    Real mirror = 0, glass = 0, bounce = 0;

    Real sum() const { return mirror + glass + bounce; }
};

Shares shares_of(const World& world, const Material& m, const Batch& b, const Surfaces& s, int i) {
    Shares shares;
    if ((world.plan.specular || world.plan.lobe) && b.depth[i] < world.scene.depth) {
        shares.weights = outgoing(m, b, s, i);
        shares.mirror = largest(shares.weights.mirror), shares.glass = largest(shares.weights.glass);
    }
    if (b.bounce[i] < world.scene.bounces) shares.bounce = largest(shares.weights.local * m.albedo);
    return shares;
}

/// The lanes that go on in one way, and what each carries on.
struct Leaving {
    int count = 0;
    Index lane[lanes];
    Colors weight;

    void add(int i, Color w) { lane[count] = i, weight.set(count++, w); }
};

struct AllLeaving {
    Leaving mirror, glossy, glass, translucent, bounce;
};

/// Decides how lanes from `begin` to `end` go on.
void choose_ways(const World& world, Pattern pattern, Dimension choice, const Batch& b, const Surfaces& s, int begin,
                 int end, AllLeaving& leaving) {
    Numbers numbers;
    bool drawn = false;
    for (Leaving* way : {&leaving.mirror, &leaving.glossy, &leaving.glass, &leaving.translucent, &leaving.bounce})
        way->count = 0;
    for (int i = begin; i < end; ++i) {
        if (s.material[i] == nothing) continue;
        const Material& m = world.scene.materials[std::size_t(s.material[i])];
        const bool sharp = m.exponent == inf;
        Leaving &mirror = sharp ? leaving.mirror : leaving.glossy, &glass = sharp ? leaving.glass : leaving.translucent;
        const Color weight = b.weight.at(i);
        const Shares shares = shares_of(world, m, b, s, i);
        const auto& [local, mirrored, refracted] = shares.weights;
        const Real sum = shares.sum();
        if (sum == 0) continue;

        if (world.plan.split) {
            if (shares.mirror > 0) mirror.add(i, weight * mirrored);
            if (shares.glass > 0) glass.add(i, weight * refracted);
            continue;
        }
        const bool alone = shares.mirror == sum || shares.glass == sum || shares.bounce == sum;
        if (!alone && !drawn) draw_1d(pattern, choice, b.key, b.sample, b.count, numbers), drawn = true;
        const Real u = alone ? 0 : sum * numbers.x[i];
        if (u < shares.mirror)
            mirror.add(i, weight * mirrored * (sum / shares.mirror));
        else if (u < shares.mirror + shares.glass)
            glass.add(i, weight * refracted * (sum / shares.glass));
        else
            leaving.bounce.add(i, weight * local * (sum / shares.bounce));
    }
}

/// Every lane with an albedo bounces, if bounces are the only way on.
void choose_bounces(const World& world, const Batch& b, const Surfaces& s, Leaving& leaving) {
    const Material* materials = world.scene.materials.data();
    leaving.count = 0;
    for (int i = 0; i < b.count; ++i) {
        const bool on = s.material[i] != nothing && b.bounce[i] < world.scene.bounces &&
                        materials[s.material[i]].albedo != Color(0);
        leaving.lane[leaving.count] = i;
        leaving.weight.set(leaving.count, b.weight.at(i));
        leaving.count += on;
    }
}

/// The new rays, side by side. Each begins at near 0 and ends nowhere.
struct Sent {
    Vectors<> origin, direction;
    Colors weight;
    Real density[lanes];  // with which a lobe took it, where that is weighed against lamps, else 0

    void set(int k, const Ray& ray) { origin.set(k, ray.origin), direction.set(k, ray.direction); }
};

/// Collects lanes that leave in one way, from `begin` on. Returns how many there are in whole vectors.
template <WayOn way>
int collect(const World& world, const Batch& b, const Surfaces& s, const Leaving& leaving, int begin, int count,
            Crossing& c) {
    constexpr bool bounces = way == WayOn::bounce;
    const int rounded = count < whole ? count : (count + whole - 1) / whole * whole;
    for (int k = 0; k < rounded; ++k) {
        const int from = begin + (k < count ? k : count - 1), i = int(leaving.lane[from]);
        c.normal.set(k, s.normal(i)), c.point.set(k, s.point.at(i)), c.flat.set(k, s.flat.at(i));
        c.error[k] = s.error[i], c.weight.set(k, leaving.weight.at(from));
        c.key[k] = b.key[i], c.sample[k] = b.sample[i];
        if constexpr (bounces) {
            c.albedo.set(k, world.reflectances[std::size_t(s.material[i]) + 1].albedo);
        } else {
            const Material& m = world.scene.materials[std::size_t(s.material[i])];
            const bool behind = s.behind[i] != 0;
            c.direction.set(k, b.direction.at(i)), c.exponent[k] = m.exponent;
            if constexpr (leads_inside(way)) c.ior_from[k] = behind ? m.ior : 1, c.ior_to[k] = behind ? 1 : m.ior;
        }
    }
    return rounded;
}

template <WayOn way>
void send(const Numbers& u, const Crossing& c, int count, Sent& sent) {
#pragma GCC ivdep
    for (int k = 0; k < count; ++k) {
        const Scattered scattered = direction_of<way>(c, k, u.at(k));
        sent.set(k, spawn_ray(c.hit(k), scattered.direction));
        sent.weight.set(k, c.weight.at(k) * scattered.weight);
        sent.density[k] = 0;
    }
}

/// With which density each lane of a glossy lobe was taken, where that is weighed against lamps.
void note_densities(const Crossing& c, int count, Sent& sent) {
    for (int k = 0; k < count; ++k)
        sent.density[k] = lobe_density(c.exponent[k], sent.direction.at(k), c.normal.at(k), -c.direction.at(k));
}

/// Brings rays back to the right side of their surfaces, to which the interpolated normals of a mesh may not send them.
/// What a lobe sends there counts in full: no sample of a lamp would have found it.
template <WayOn way>
void bring_back(const Crossing& c, int count, Sent& sent) {
    for (int k = 0; k < count; ++k) {
        const Hit hit = c.hit(k);
        const vec3 way_on = sent.direction.at(k);
        if (c.normal.at(k) == hit.normal || !is_astray(way_on, hit.normal, leads_inside(way))) continue;
        sent.set(k, spawn_ray(hit, turned(way_on, hit.normal)));
        if constexpr (way == WayOn::glossy) sent.density[k] = 0;
    }
}

/// Adds the new rays to a batch, with what stays with their paths, but for those that carry nothing or have nowhere to
/// go.
template <WayOn way>
void append(const World& world, Sampler sampler, const Batch& b, const Surfaces& s, const Sent& sent, const Index* from,
            int count, Batch& to) {
    constexpr bool bounces = way == WayOn::bounce, enters = leads_inside(way);
    constexpr Event event = bounces ? Event::diffuse : is_sharp(way) ? Event::specular : Event::lobe;
    const bool media = world.plan.medium, through = world.plan.through, media_lit = world.plan.media_lit;
    for (int k = 0; k < count; ++k) {
        const int i = int(from[k]), j = to.count;
        to.set_ray(j, {sent.origin.at(k), sent.direction.at(k), 0, inf});
        to.weight.set(j, sent.weight.at(k));
        // Mirror and glass may both be followed: their random numbers must not be the same.
        to.key[j] = enters ? branch_key(b.key[i], sampler) : b.key[i];
        to.sample[j] = b.sample[i];
        to.time[j] = b.time[i];
        to.slot[j] = b.slot[i];
        to.event[j] = Index(event);
        to.depth[j] = b.depth[i] + !bounces;
        to.bounce[j] = b.bounce[i] + bounces;
        if constexpr (!bounces && !is_sharp(way)) to.density[j] = sent.density[k];
        to.inside[j] = b.inside[i];
        if constexpr (enters) {
            // Where shadow rays go through, they have gathered what a diffuse ray finds behind: it still is one.
            const Material& m = world.scene.materials[std::size_t(s.material[i])];
            if (through && b.event[i] == Index(Event::diffuse) && goes_straight_through(m)) to.event[j] = b.event[i];
            // So does what a medium has scattered, which is weighed.
            if (media_lit && b.event[i] == Index(Event::medium) && goes_straight_through(m)) {
                to.event[j] = b.event[i];
                to.density[j] = b.density[i] * left_around(world, b.inside[i], b.far[i]);
                to.way[j] = b.way[i] + b.far[i];
            }
            if (media) to.inside[j] = world.regions.crossed(b.inside[i], b.shape[i], s.behind[i] != 0);
        }
        to.count += !(sent.weight.at(k) == Color(0) || sent.direction.at(k) == vec3(0));
    }
}

template <WayOn way>
[[gnu::noinline]] void follow(const World& world, Pattern pattern, int wave, const Batch& b, const Surfaces& s,
                              const Leaving& leaving, Queue& next, Chunk& chunk) {
    constexpr RayKind kind = way == WayOn::mirror   ? RayKind::mirror
                             : way == WayOn::glass  ? RayKind::glass
                             : way == WayOn::bounce ? RayKind::bounce
                                                    : RayKind::lobe;
    Crossing crossing;
    Sent sent;
    Numbers u;
    for (int k = 0; k < leaving.count;) {
        Batch& to = next.open();
        const int before = to.count, taken = std::min(leaving.count - k, lanes - before);
        const int count = collect<way>(world, b, s, leaving, k, taken, crossing);
        if constexpr (!is_sharp(way))
            draw_2d(pattern, wave_dimension(world, wave, lobe_dimension, pattern.n), crossing.key, crossing.sample,
                    count, u);
        send<way>(u, crossing, count, sent);
        if (way == WayOn::glossy && world.plan.weigh) note_densities(crossing, count, sent);
        if (way == WayOn::bounce && world.plan.roulette) {
            draw_1d(pattern, wave_dimension(world, wave, roulette_dimension, pattern.n), crossing.key, crossing.sample,
                    count, u);
            for (int j = 0; j < count; ++j) sent.weight.set(j, after_roulette(sent.weight.at(j), u.x[j]));
        }
        if (way != WayOn::bounce && world.plan.smooth) bring_back<way>(crossing, taken, sent);
        append<way>(world, pattern.sampler, b, s, sent, leaving.lane + k, taken, to);
        chunk.rays[int(kind)] += std::uint64_t(to.count - before);
        k += taken;
    }
}

}  // namespace

void scatter_stage(const Wave& w, Queue& next, Chunk& chunk) {
    const World& world = w.world;
    const Pattern pattern = w.pattern;
    const int wave = w.number;
    const Batch& b = w.batch;
    const Surfaces& s = w.surfaces;
    const RenderPlan& plan = world.plan;
    if (!plan.specular && !plan.lobe && !plan.bounce) return;
    const Dimension choice = wave_dimension(world, wave, choice_dimension, pattern.n);
    AllLeaving leaving;
    const auto mirror = [&] { follow<WayOn::mirror>(world, pattern, wave, b, s, leaving.mirror, next, chunk); };
    const auto glass = [&] { follow<WayOn::glass>(world, pattern, wave, b, s, leaving.glass, next, chunk); };
    const auto bounce = [&] { follow<WayOn::bounce>(world, pattern, wave, b, s, leaving.bounce, next, chunk); };
    if (plan.split) {
        // Two paths may add to one sample: lane by lane, so that the order of the sum does not depend on what else is
        // in the batch.
        for (int i = 0; i < b.count; ++i) {
            choose_ways(world, pattern, choice, b, s, i, i + 1, leaving);
            mirror();
            glass();
        }
    } else if (!plan.specular && !plan.lobe) {
        choose_bounces(world, b, s, leaving.bounce);
        bounce();
    } else {
        choose_ways(world, pattern, choice, b, s, 0, b.count, leaving);
        mirror();
        follow<WayOn::glossy>(world, pattern, wave, b, s, leaving.glossy, next, chunk);
        glass();
        follow<WayOn::translucent>(world, pattern, wave, b, s, leaving.translucent, next, chunk);
        bounce();
    }
}

}  // namespace rt
