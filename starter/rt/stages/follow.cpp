#include "rt/stages/follow.h"

#include "rt/lamps/importance.h"
#include "rt/stages/scatter.h"

/// Sends the rays of the lanes that go on in one way, side by side, and adds those that carry anything to the next
/// wave. Nobody needs this file for the assignment.
///
///     collect     the lanes of one way
///     send        their new rays; direction_of calls the way's fragment
///     bring_back  those that a mesh's interpolated normals have led astray
///     append      one that carries anything, with what stays with its path
///     follow      all of it, as many as the open batch has room for at once
///     follow_both mirror and glass of each lane, where both are followed
namespace rt {
namespace {

/// Loops over some of the lanes take a multiple of so many, the last one more than once: vectors have no rest.
constexpr int whole = 8;

/// What decides where lanes go on, side by side: of Arrival, what the way needs.
struct Crossing {
    Vectors<> direction, normal;
    Vectors<> point, flat;
    Real error[lanes];
    Real exponent[lanes], ior_from[lanes], ior_to[lanes];
    Colors albedo;
    Colors weight;
    Bits key[lanes];
    int sample[lanes];

    Hit hit(int k) const { return {point.at(k), flat.at(k), error[k]}; }

    template <WayOn way>
    [[gnu::always_inline]] Arrival arrival(int k) const {
        Arrival a;
        a.normal = normal.at(k);
        if constexpr (way == WayOn::bounce)
            a.albedo = albedo.at(k);
        else
            a.direction = direction.at(k), a.exponent = exponent[k];
        if constexpr (leads_inside(way)) a.ior = {ior_from[k], ior_to[k]};
        return a;
    }
};

/// The new rays, side by side. Each begins at near 0 and ends nowhere.
struct Sent {
    Vectors<> origin, direction;
    Colors weight;
    Real density[lanes];  // with which a lobe took it, where that is weighed against lamps, else 0

    void set(int k, const Ray& ray) { origin.set(k, ray.origin), direction.set(k, ray.direction); }
};

/// Collects lanes that leave in one way, from `begin` on. Returns how many there are in whole vectors.
template <WayOn way>
int collect(const Wave& wave, const Leaving& leaving, int begin, int count, Crossing& c) {
    const Batch& b = wave.batch;
    const Surfaces& s = wave.surfaces;
    constexpr bool bounces = way == WayOn::bounce;
    const int rounded = count < whole ? count : (count + whole - 1) / whole * whole;
    for (int k = 0; k < rounded; ++k) {
        const int from = begin + (k < count ? k : count - 1), i = int(leaving.lane[from]);
        c.normal.set(k, s.normal(i)), c.point.set(k, s.point.at(i)), c.flat.set(k, s.flat.at(i));
        c.error[k] = s.error[i], c.weight.set(k, leaving.weight.at(from));
        c.key[k] = b.key[i], c.sample[k] = b.sample[i];
        if constexpr (bounces) {
            c.albedo.set(k, wave.world.reflectances[std::size_t(s.material[i]) + 1].albedo);
        } else {
            const Material& m = wave.material(i);
            c.direction.set(k, b.direction.at(i)), c.exponent[k] = m.exponent;
            if constexpr (leads_inside(way)) {
                const Iors ior = iors_of(m, s.behind[i] != 0);
                c.ior_from[k] = ior.from, c.ior_to[k] = ior.to;
            }
        }
    }
    return rounded;
}

template <WayOn way>
void send(const Numbers& u, const Crossing& c, int count, Sent& sent) {
#pragma GCC ivdep
    for (int k = 0; k < count; ++k) {
        const Scattered scattered = direction_of(way, c.arrival<way>(k), u.at(k));
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

/// What crossing the surface of lane i changes of lane j of the next wave.
void cross_boundary(const Wave& wave, int i, Batch& to, int j) {
    const World& world = wave.world;
    const Batch& b = wave.batch;
    const bool diffuse = world.plan.through && b.event[i] == Index(Event::diffuse),
               scattered = world.plan.media_lit && b.event[i] == Index(Event::medium);
    if ((diffuse || scattered) && goes_straight_through(wave.material(i))) {
        // Shadow rays go through, and have gathered what the path finds behind: it counts as what it was.
        to.event[j] = b.event[i];
        if (scattered) {  // which is weighed
            to.density[j] = b.density[i] * left_around(world, b.inside[i], b.far[i]);
            to.way[j] = b.way[i] + b.far[i];
        }
    }
    if (world.plan.medium) to.inside[j] = world.regions.crossed(b.inside[i], b.shape[i], wave.surfaces.behind[i] != 0);
}

/// Adds new ray k, of lane i, to a batch, unless it carries nothing or has nowhere to go.
template <WayOn way>
[[gnu::always_inline]] inline void append(const Wave& wave, const Sent& sent, int k, int i, Batch& to) {
    constexpr bool bounces = way == WayOn::bounce;
    constexpr Event event = bounces ? Event::diffuse : is_sharp(way) ? Event::specular : Event::lobe;
    const int j = to.count;
    to.continue_path(j, wave.batch, i);
    to.set_ray(j, {sent.origin.at(k), sent.direction.at(k), 0, inf});
    to.weight.set(j, sent.weight.at(k));
    to.event[j] = Index(event);
    to.depth[j] += !bounces, to.bounce[j] += bounces;
    if constexpr (!bounces && !is_sharp(way)) to.density[j] = sent.density[k];
    if constexpr (leads_inside(way)) {
        // Mirror and glass may both be followed: their random numbers must not be the same.
        to.key[j] = branch_key(to.key[j], wave.pattern.sampler);
        cross_boundary(wave, i, to, j);
    }
    to.count += !(sent.weight.at(k) == Color(0) || sent.direction.at(k) == vec3(0));
}

/// All rays of a way that takes no random numbers.
template <WayOn way>
void send_all(const Wave& wave, const Leaving& leaving, Crossing& crossing, Sent& sent) {
    const Numbers none{};
    send<way>(none, crossing, collect<way>(wave, leaving, 0, leaving.count, crossing), sent);
    if (wave.world.plan.smooth) bring_back<way>(crossing, leaving.count, sent);
}

}  // namespace

template <WayOn way>
[[gnu::noinline]] void follow(const Wave& wave, const AllLeaving& all, Queue& next, Chunk& chunk) {
    const RenderPlan& plan = wave.world.plan;
    const Leaving& leaving = all[way];
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
        const int count = collect<way>(wave, leaving, k, taken, crossing);
        const auto dimension = [&](int of_wave) {
            return wave_dimension(wave.world, wave.number, of_wave, wave.pattern.n);
        };
        if constexpr (!is_sharp(way))
            draw_2d(wave.pattern, dimension(lobe_dimension), crossing.key, crossing.sample, count, u);
        send<way>(u, crossing, count, sent);
        if (way == WayOn::glossy && plan.weigh) note_densities(crossing, count, sent);
        if (way == WayOn::bounce && plan.roulette) {
            draw_1d(wave.pattern, dimension(roulette_dimension), crossing.key, crossing.sample, count, u);
            for (int j = 0; j < count; ++j) sent.weight.set(j, after_roulette(sent.weight.at(j), u.x[j]));
        }
        if (way != WayOn::bounce && plan.smooth) bring_back<way>(crossing, taken, sent);
        for (int j = 0; j < taken; ++j) append<way>(wave, sent, j, int(leaving.lane[k + j]), to);
        chunk.rays[int(kind)] += std::uint64_t(to.count - before);
        k += taken;
    }
}

void follow_both(const Wave& wave, const AllLeaving& all, Queue& next, Chunk& chunk) {
    const Leaving &mirror = all[WayOn::mirror], &glass = all[WayOn::glass];
    Crossing crossing;
    Sent mirrored, refracted;
    send_all<WayOn::mirror>(wave, mirror, crossing, mirrored);
    send_all<WayOn::glass>(wave, glass, crossing, refracted);
    for (int m = 0, g = 0; m < mirror.count || g < glass.count;) {
        Batch& to = next.open();
        const int before = to.count;
        const bool mirrors = g == glass.count || (m < mirror.count && mirror.lane[m] <= glass.lane[g]);
        if (mirrors)
            append<WayOn::mirror>(wave, mirrored, m, int(mirror.lane[m]), to), ++m;
        else
            append<WayOn::glass>(wave, refracted, g, int(glass.lane[g]), to), ++g;
        chunk.rays[int(mirrors ? RayKind::mirror : RayKind::glass)] += std::uint64_t(to.count - before);
    }
}

template void follow<WayOn::mirror>(const Wave&, const AllLeaving&, Queue&, Chunk&);
template void follow<WayOn::glossy>(const Wave&, const AllLeaving&, Queue&, Chunk&);
template void follow<WayOn::glass>(const Wave&, const AllLeaving&, Queue&, Chunk&);
template void follow<WayOn::translucent>(const Wave&, const AllLeaving&, Queue&, Chunk&);
template void follow<WayOn::bounce>(const Wave&, const AllLeaving&, Queue&, Chunk&);

}  // namespace rt
