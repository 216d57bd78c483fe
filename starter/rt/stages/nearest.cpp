#include <utility>

#include "rt/fragments.h"
#include "rt/stages/stages.h"
#include "rt/tree/beam.h"
#include "rt/tree/meetings.h"
#include "rt/tree/shaft.h"
#include "rt/tree/shears.h"
#include "rt/tree/traverse.h"

namespace rt {
namespace {

/// Where a ray meets a disc, from either side: t with near < t < far, else inf.
inline Real hit_disc(const Disc& disc, const Ray& ray) {
    const vec3 middle = disc.center - ray.origin;
    const Real t = dot(middle, disc.normal) / dot(ray.direction, disc.normal);
    const vec3 p = t * ray.direction - middle;
    if (!(dot(p, p) <= disc.radius * disc.radius)) return inf;
    return ray.near < t && t < ray.far ? t : inf;
}

inline Sphere at_time(Sphere s, vec3 velocity, Real time) { return {moved(s.center, velocity, time), s.radius}; }
inline Quad at_time(Quad q, vec3 velocity, Real time) { return {moved(q.center, velocity, time), q.u, q.v}; }
inline Disc at_time(Disc d, vec3 velocity, Real time) { return {moved(d.center, velocity, time), d.normal, d.radius}; }
inline Triangle at_time(Triangle t, vec3 velocity, Real time) {
    return {moved(t.a, velocity, time), moved(t.b, velocity, time), moved(t.c, velocity, time)};
}

/// One shape against all rays of a batch. Of two shapes at one distance the one with the lower number is hit.
template <auto hit, bool moves, class Shape>
[[gnu::noinline]] void try_shape(const Shape& in_memory, vec3 velocity, Index id, Batch& b) {
    const Shape shape = in_memory;
#pragma GCC ivdep
    for (int i = 0; i < lanes; ++i) {
        const Ray ray = b.ray(i);
        Real t;
        if constexpr (moves)
            t = hit(at_time(shape, velocity, b.time[i]), ray);
        else
            t = hit(shape, ray);
        const bool closer = t < ray.far;
        b.far[i] = closer ? t : ray.far;
        b.shape[i] = closer ? id : b.shape[i];
    }
}

/// All of a kind, one by one. first is the number of the first of them.
template <auto hit, class Shape>
void try_shapes(const World& world, const LargeVector<Shape>& shapes, Index first, const Shaft& shaft, Batch& b) {
    const Box* const boxes = world.boxes.empty() ? nullptr : world.boxes.data();  // none: all shapes are tried
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        const Index id = first + Index(k);
        if (boxes && !may_meet(shaft, boxes[id])) continue;
        const vec3 velocity = world.surfaces[std::size_t(id)].velocity;
        with_flag(velocity != vec3(0), [&](auto moves) { try_shape<hit, moves()>(shapes[k], velocity, id, b); });
    }
}

template <auto hit, class Shape>
[[gnu::noinline]] void test_pairs(const Shapes<Shape>& shapes, const Rays& rays, Real* distance) {
#pragma GCC ivdep
    for (int k = 0; k < pairs_at_once; ++k) distance[k] = hit(shapes.at(k), rays.at(k));
}

/// Finds the distances from rays to items of one kind, which follow each other in the list from begin to end.
template <auto hit, bool time, class Shape>
void measure(const World& world, const LargeVector<Shape>& all, Index first, const Batch& b, const Real* far,
             Meetings& m, int begin, int end) {
    Rays rays{};
    Shapes<Shape> shapes{};
    alignas(64) Real distance[pairs_at_once];
    for (int k = begin; k < end; ++k) __builtin_prefetch(&all[std::size_t(m.item(k) - first)]);
    for (; begin < end; begin += pairs_at_once) {
        const int count = std::min(pairs_at_once, end - begin);
        for (int k = 0; k < count; ++k) {
            const int i = int(m.lane(begin + k));
            const std::size_t id = std::size_t(m.item(begin + k));
            const Shape& shape = all[id - std::size_t(first)];
            rays.origin.set(k, b.origin.at(i));
            rays.direction.set(k, b.direction.at(i));
            rays.near[k] = b.near[i], rays.far[k] = far[i];
            if constexpr (time)
                shapes.set(k, at_time(shape, world.surfaces[id].velocity, b.time[i]));
            else
                shapes.set(k, shape);
        }
        test_pairs<hit>(shapes, rays, distance);
        std::copy(distance, distance + count, m.distance + begin);
    }
}

/// Distances of all that the rays meet, kind by kind, as items are numbered: spheres, triangles, quads, discs.
template <bool time>
void measure_all(const World& world, const Batch& b, const Real* far, Meetings& m) {
    const RenderPlan& plan = world.plan;
    if (plan.triangles && !plan.spheres && !plan.quads && !plan.discs)
        return measure<hit_triangle, time>(world, world.triangles, 0, b, far, m, 0, m.count);
    const Index firsts[] = {0, world.first_triangle, world.first_quad, world.first_disc};
    const auto kind_of = [&](Index item) { return (item >= firsts[1]) + (item >= firsts[2]) + (item >= firsts[3]); };
    std::uint64_t sorted[Meetings::most];
    int ends[4] = {}, n = 0;
    for (int kind = 0; kind < 4; ++kind) {
        for (int k = 0; k < m.count; ++k)
            if (kind_of(m.item(k)) == kind) sorted[n++] = m.pair[k];
        ends[kind] = n;
    }
    std::copy(sorted, sorted + n, m.pair);
    measure<hit_sphere, time>(world, world.spheres, firsts[0], b, far, m, 0, ends[0]);
    measure<hit_triangle, time>(world, world.triangles, firsts[1], b, far, m, ends[0], ends[1]);
    measure<hit_quad, time>(world, world.quads, firsts[2], b, far, m, ends[1], ends[2]);
    measure<hit_disc, time>(world, world.discs, firsts[3], b, far, m, ends[2], ends[3]);
}

/// Tests the pairs that have come together, and calls found(ray) for each ray that has met something nearer.
///
/// far  of the rays as they came: the lowest number wins a tie, whichever is tried first
template <class F>
void settle(const World& world, Batch& b, const Real* far, Meetings& meetings, F found) {
    with_flag(world.plan.time, [&](auto time) { measure_all<time()>(world, b, far, meetings); });
    for (int k = 0; k < meetings.count; ++k) {
        const int i = int(meetings.lane(k));
        const Real t = meetings.distance[k];
        const Index id = meetings.item(k);
        if (!(t < b.far[i] || (t == b.far[i] && id < b.shape[i]))) continue;
        b.far[i] = t;
        b.shape[i] = id;
        found(i);
    }
    meetings.count = 0;
}

/// Rays side by side.
template <bool any>
void search_together(const World& world, const Real* far, Journeys& journeys, Beam& beam, Meetings& meetings,
                     Batch& b) {
    Shears shears;
    const bool sheared = !world.bvh.corners.empty() && start(journeys, beam, shears);
    const auto sieve = [&](const Bvh::Node& leaf, unsigned child, std::uint64_t rays) {
        // Sixteen rays are sieved at a time: for one or two, testing them takes as long.
        if (!sheared || std::popcount(rays) <= 2) return rays;
        return may_hit(world.bvh.corners[leaf.corners], int(child), shears, rays);
    };
    // A node that only so few want is left to each by itself: tried on the meshes of tests/bench/rays.py. Where any hit
    // will do, more may leave the beam: what is near need not come first.
    const int few = beam.spread > widest_beam ? lanes : any ? 12 : 2;
    std::uint64_t alive = ~std::uint64_t(0);
    for (bool root = true; beam.depth > 0; root = false) {
        step(world.bvh.nodes.data(), journeys, alive, root ? 0 : few, sieve, beam, meetings);
        if (meetings.count == 0 || (meetings.count < Meetings::enough && beam.depth > 0)) continue;
        settle(world, b, far, meetings, [&](int i) {
            if (any)
                journeys.far[i] = -1, alive &= ~(std::uint64_t(1) << i);
            else
                set_far(journeys, i, b.far[i]);
        });
        find_far(journeys, beam);
    }
    if (beam.left) turn_stacks(journeys);
}

/// The rays that go different ways, and what each does next.
struct Paths {
    int going[lanes], waiting[lanes];  // on to a node; for what they may have hit to be tested
    int go = 0, wait = 0;
};

/// Puts together the pairs from the leaves that rays have come to. A ray that hits nothing there goes on.
inline void look_into_leaves(const Bvh& bvh, const Journeys& journeys, const Shears& shears, Visits& visits,
                             Meetings& meetings, Paths& paths) {
    for (int k = 0; k < visits.count; ++k) {
        const int i = visits.lane[k];
        const Bvh::Node& leaf = bvh.nodes[visits.node[k]];
        if (k + 4 < visits.count && !bvh.corners.empty()) fetch(bvh.corners[bvh.nodes[visits.node[k + 4]].corners]);
        unsigned met = visits.met[k];
        if (!bvh.corners.empty()) met &= may_hit(bvh.corners[leaf.corners], shears, i);
        const bool waits = add_pairs(leaf, i, met, meetings) != 0, goes_on = journeys.depth[i] > 0;
        paths.waiting[paths.wait] = paths.going[paths.go] = i;
        paths.wait += goes_on & waits, paths.go += goes_on & !waits;
    }
    visits.count = 0;
}

/// Rays that go different ways.
template <bool any>
void search_each(const World& world, const Real* far, Journeys& journeys, Meetings& meetings, Batch& b) {
    const Bvh& bvh = world.bvh;
    Paths paths;
    for (int i = 0; i < b.count; ++i)
        if (journeys.depth[i] > 0 && journeys.far[i] >= 0) paths.going[paths.go++] = i;
    if (paths.go == 0) return;
    Shears shears;
    const bool sheared = !bvh.corners.empty();
    if (sheared) start(journeys, shears);
    Visits visits;
    while (paths.go > 0 || paths.wait > 0) {
        const int n = std::exchange(paths.go, 0);
        for (int k = 0; k < n; ++k) {
            const int i = paths.going[k];
            const bool leaf = step(bvh.nodes.data(), journeys, i, visits), goes_on = journeys.depth[i] > 0;
            fetch(bvh.nodes[std::uint32_t(journeys.stack[i][journeys.depth[i]])]);  // while other rays make their steps
            paths.going[paths.go] = i;
            paths.go += goes_on & !leaf;
        }
        if (visits.count < Visits::enough && paths.go > 0) continue;
        look_into_leaves(bvh, journeys, shears, visits, meetings, paths);
        if (meetings.count < Meetings::enough && paths.go > 0) continue;
        settle(world, b, far, meetings, [&](int i) {
            if (any)
                journeys.depth[i] = 0;
            else
                shorten(journeys, i, b.far[i]);
        });
        for (int k = 0; k < paths.wait; ++k) {
            paths.going[paths.go] = paths.waiting[k];
            paths.go += journeys.depth[paths.waiting[k]] > 0;
        }
        paths.wait = 0;
    }
}

template <bool any>
void search_tree(const World& world, Batch& b) {
    Journeys journeys;
    Meetings meetings;
    Beam beam;
    meetings.count = 0;
    start(world.bvh, b, journeys);
    start(journeys, beam);
    Real far[lanes];
    std::copy(b.far, b.far + lanes, far);
    // Where any hit will do, all rays look at the root together, wherever they go.
    const bool together = world.bvh.nodes.size() <= most_nodes && (any || beam.spread <= widest_beam);
    begin(journeys, !together);
    if (together) search_together<any>(world, far, journeys, beam, meetings, b);
    search_each<any>(world, far, journeys, meetings, b);
}

template <bool any>
[[gnu::noinline]] void search(const World& world, Batch& b) {
    if (world.plan.bvh) return search_tree<any>(world, b);
    const Shaft shaft = shaft_of(b);
    if (shaft.empty()) return;
    try_shapes<hit_sphere>(world, world.spheres, 0, shaft, b);
    try_shapes<hit_triangle>(world, world.triangles, world.first_triangle, shaft, b);
    try_shapes<hit_quad>(world, world.quads, world.first_quad, shaft, b);
    try_shapes<hit_disc>(world, world.discs, world.first_disc, shaft, b);
}

}  // namespace

void nearest_stage(const World& world, Batch& batch) { search<false>(world, batch); }

void any_hit_stage(const World& world, Batch& batch) { search<true>(world, batch); }

}  // namespace rt
