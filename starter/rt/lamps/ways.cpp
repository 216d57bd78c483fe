#include "rt/lamps/ways.h"

#include <fmt/format.h>

#include "rt/lamps/importance.h"
#include "rt/lamps/lamp_tree.h"
#include "rt/media/bodies.h"
#include "rt/sampler.h"

/// Which way is the best depends on the noise that each adds. That is reckoned at some points that are seen, from what
/// the lamps send there: without shadows, and before any ray is sent. Each is a variance over the square of the light.
namespace rt {
namespace {

/// From where on quads are sampled by solid angle, which takes up to a third longer; where one lamp is chosen, less.
constexpr Real worth_solid_angle = 0.2, worth_solid_angle_of_one = 0.1;

/// One of n lamps, not fewer than four, is chosen where that leaves at most this times n the variance of all: for each
/// other one, a shadow ray is saved.
constexpr Real worth_one_lamp = 0.35;
constexpr int fewest_to_choose = 4;

/// Of more lamps, one is chosen: with all, a first sample of each pixel takes longer than a picture may.
constexpr std::size_t most_to_take = 256;

/// What the directions of bounces add to the variance, however lamps are sampled.
constexpr Real noise_of_bounces = 0.1;

/// From where on lamps are sampled for lobes, too: for each lamp, which takes a shadow ray; and where one is chosen.
constexpr Real worth_weighing = 0.15, worth_weighing_one = 0.55;

/// From where on lamps are sampled where media scatter: for each lamp, which takes a shadow ray; and where one is
/// chosen. See tests/bench/walks.py.
constexpr Real worth_lighting_media = 0.6, worth_lighting_media_by_one = 1;

/// Lines of sight times shapes, and points times parts of lamps: a plan takes milliseconds.
constexpr Real most_work = 2e5;

struct Point {
    vec3 place, normal, to_viewer;  // unit; the normal is on the viewer's side [world]
    const Material* material;
    const Shape* shape;  // none: a mesh
};

/// A line of sight. Where it meets a shape, and the normal there; inf: nowhere. Not by fragments: the plan must not
/// depend on them. Triangles are left out: what lies about them is as near to the lamps.
struct Sight {
    vec3 origin, direction;

    std::pair<Real, vec3> meets(const Sphere& s) const {
        const vec3 to = s.center - origin;
        const Real middle = dot(to, direction), square = sqr(middle) - dot(to, to) + sqr(s.radius);
        return {square > 0 ? middle - std::sqrt(square) : inf, unit((middle - safe_sqrt(square)) * direction - to)};
    }
    std::pair<Real, vec3> meets(const Quad& q) const {
        const vec3 n = unit(cross(q.u, q.v));
        const Real t = to_plane(q.center, n);
        const vec3 p = origin + t * direction - q.center;
        return {std::abs(dot(p, q.u)) <= dot(q.u, q.u) && std::abs(dot(p, q.v)) <= dot(q.v, q.v) ? t : inf, n};
    }
    std::pair<Real, vec3> meets(const Disc& d) const {
        const Real t = to_plane(d.center, d.normal);
        const vec3 p = origin + t * direction - d.center;
        return {dot(p, p) <= sqr(d.radius) ? t : inf, d.normal};
    }
    std::pair<Real, vec3> meets(const Triangle&) const { return {inf, vec3(0)}; }

private:
    Real to_plane(vec3 center, vec3 n) const { return dot(center - origin, n) / dot(direction, n); }
};

/// from  the shape on which the line starts
void add_first_met(const Scene& scene, const Sight& sight, const Shape* from, std::vector<Point>& points) {
    Real nearest = inf;
    Point point{};
    for (const Shape& shape : scene.shapes) {
        const auto [t, n] = std::visit([&](const auto& s) { return sight.meets(s); }, shape.geometry);
        if (!(t > 0 && t < nearest) || &shape == from) continue;
        nearest = t, point.shape = &shape;
        point.normal = dot(n, sight.direction) > 0 ? -n : n;
        point.material = &scene.materials[std::size_t(shape.material)];
    }
    point.place = sight.origin + nearest * sight.direction, point.to_viewer = -sight.direction;
    if (nearest < inf) points.push_back(point);
}

/// Some triangles of a mesh that face the eye, whether or not something is before them.
void add_mesh(const Scene& scene, const Mesh& mesh, std::size_t most, std::vector<Point>& points) {
    const std::size_t step = mesh.triangles.size() / most + 1;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
        const glm::ivec3 corners = mesh.triangles[k];
        const vec3 a = mesh.vertices[std::size_t(corners.x)], b = mesh.vertices[std::size_t(corners.y)],
                   c = mesh.vertices[std::size_t(corners.z)];
        const vec3 place = (a + b + c) / 3.0, n = unit(cross(b - a, c - a)), to_viewer = unit(scene.camera.eye - place);
        if (dot(n, to_viewer) > 0)
            points.push_back({place, n, to_viewer, &scene.materials[std::size_t(mesh.material)], nullptr});
    }
}

/// What the camera sees at the middles of side x side parts of the film; and where light bounces, what is seen from
/// there.
std::vector<Point> points_in_sight(const Scene& scene, int side) {
    const Camera& c = scene.camera;
    std::vector<Point> points;
    for (int k = 0; k < side * side; ++k) {
        const vec2 film{(2 * (k % side) + 1.0) / side - 1, 1 - (2 * (k / side) + 1.0) / side};
        const vec2 slope = c.tan_half_fov * vec2(film.x * c.size.x / c.size.y, film.y);
        add_first_met(scene, {c.eye, unit(slope.x * c.right + slope.y * c.up - c.back)}, nullptr, points);
    }
    for (const Mesh& mesh : scene.meshes) add_mesh(scene, mesh, std::size_t(side * side), points);
    const std::size_t seen = scene.bounces > 0 ? points.size() : 0;
    for (std::size_t k = 0; k < seen; ++k) {
        const vec2 u = sobol_2d(1, std::uint32_t(k), 0), circle = std::sqrt(u.x) * unit_circle(u.y);
        const Point from = points[k];
        add_first_met(scene, {from.place, frame_about(from.normal).to_world({circle, std::sqrt(1 - u.x)})}, from.shape,
                      points);
    }
    return points;
}

/// A lamp as a quad of its area, which faces the point where it is a ball.
Quad as_quad(const Emitter& lamp, vec3 p) {
    if (lamp.kind == Emitter::Kind::quad) return lamp.quad;
    const Frame frame = frame_about(lamp.kind == Emitter::Kind::disc ? lamp.disc.normal : unit(p - lamp.sphere.center));
    const Real half = std::sqrt(area(lamp)) / 2;
    return {center(lamp), half * frame.x, half * frame.y};
}

/// What a lamp of radiance 1 sends to a point.
struct Light {
    Real mean = 0;    // irradiance
    Real within = 0;  // variance of a sample by area
    Real excess = 0;  // and how much of it one by solid angle would not have
    Real share = 0;   // of the rays of a lobe, that find it
};

Light light_of(const Emitter& lamp, const Point& p) {
    constexpr int side = 4;
    const Quad quad = as_quad(lamp, p.place);
    const vec3 n = unit(cross(quad.u, quad.v));
    const bool lobe = p.material->exponent < inf && p.material->reflectance != Color(0);
    const Real whole = area(lamp), part = whole / (side * side);
    Real angle = 0, by_area = 0, by_angle = 0;
    Light light;
    for (int k = 0; k < side * side; ++k) {
        const vec2 at{(2 * (k % side) + 1.0) / side - 1, (2 * (k / side) + 1.0) / side - 1};
        const vec3 to = quad.center + at.x * quad.u + at.y * quad.v - p.place;
        const Real square = dot(to, to), cosine = dot(p.normal, to) / std::sqrt(square);
        const Real seen = -dot(n, to) / (square * std::sqrt(square));
        if (!(cosine > 0 && seen > 0)) continue;
        angle += part * seen, light.mean += part * cosine * seen;
        by_area += part * whole * sqr(cosine * seen), by_angle += part * sqr(cosine) * seen;
        if (lobe) light.share += part * seen * lobe_density(p.material->exponent, unit(to), p.normal, p.to_viewer);
    }
    light.within = std::max<Real>(by_area - sqr(light.mean), 0);
    if (lamp.kind == Emitter::Kind::quad) light.excess = std::max<Real>(by_area - angle * by_angle, 0);
    light.share = std::min<Real>(light.share, 1);
    return light;
}

Real sum(Color c) { return c.x + c.y + c.z; }

/// What samples by area, and lobes alone, have more of in all that is in sight; and what all there is if each lamp is
/// sampled, and if one is.
struct Noise {
    Real by_area = 0, by_lobes = 0, of_all = 0, of_one = 0;
};

/// Adds the noise of the lamps' light at a point. Returns that light.
Real add_noise(const std::vector<Emitter>& lamps, const LampTree& tree, const Point& p, Noise& noise) {
    const Real diffuse = sum(largest_albedo(*p.material) + p.material->specular) / pi,
               lobe = sum(p.material->reflectance);
    Real by_surfaces = 0, by_lobes = 0, squares = 0;
    for (std::size_t l = 0; l < lamps.size(); ++l) {
        const Light from = light_of(lamps[l], p);
        const Real by_surface = diffuse * sum(lamps[l].radiance), by_lobe = lobe * sum(lamps[l].radiance);
        const Real within = sqr(by_surface) * from.within, chosen = tree.probability(l, p.place);
        by_surfaces += by_surface * from.mean, by_lobes += by_lobe * from.share;
        squares += (sqr(by_surface * from.mean) + within) / chosen;
        noise.of_all += within;
        noise.by_area += sqr(by_surface) * from.excess;
        noise.by_lobes += sqr(by_lobe) * from.share * (1 - from.share);
    }
    noise.of_one += squares - sqr(by_surfaces);
    return by_surfaces + by_lobes;
}

/// What pixels on the edge of a lamp add to the variance, in whatever way lamps are sampled: its own radiance is the
/// brightest there is. In pixels times radiance squared; hidden or not.
Real edge_of(const Emitter& lamp, const Camera& c) {
    const vec3 to = center(lamp) - c.eye;
    const Real along = -dot(to, c.back), scale = c.size.y / (2 * c.tan_half_fov * along);
    const bool on_film = along > 0 && std::abs(dot(to, c.right)) * scale < 0.5 * c.size.x &&
                         std::abs(dot(to, c.up)) * scale < 0.5 * c.size.y;
    const Real cosine = lamp.kind == Emitter::Kind::sphere ? 1 : -dot(unit(normal(lamp)), unit(to));
    if (!on_film || !(cosine > 0)) return 0;
    // A square's edge is in four roots of its area, where the share x of a pixel that it covers is between 0 and 1: the
    // mean of x (1 - x) is 1/6.
    const Real pixels = area(lamp) * cosine * sqr(scale);
    return sqr(sum(lamp.radiance)) * std::min(pixels, 4 * std::sqrt(pixels) / 6);
}

Noise noise_of(const Scene& scene, const std::vector<Emitter>& lamps) {
    const Real work = Real(scene.shapes.size() + 16 * lamps.size());
    const int side = std::clamp(int(std::sqrt(most_work / work)), 4, 24);
    const LampTree tree(lamps);
    Noise noise;
    Real all = 0, edges = 0;
    for (const Point& p : points_in_sight(scene, side)) all += sqr(add_noise(lamps, tree, p, noise));
    if (!(all > 0)) return {};
    const ivec2 size = scene.camera.size;
    for (const Emitter& lamp : lamps) edges += edge_of(lamp, scene.camera) * sqr(side) / (Real(size.x) * size.y);
    const Real for_any = edges / all + (scene.bounces > 0 ? noise_of_bounces : 0);
    return {noise.by_area / all, noise.by_lobes / all, noise.of_all / all + for_any, noise.of_one / all + for_any};
}

/// The share of all directions in which a lamp is seen.
Real share_of_directions(const Emitter& lamp, vec3 p) {
    constexpr int side = 4;
    const Quad quad = as_quad(lamp, p);
    const vec3 n = unit(cross(quad.u, quad.v));
    Real angle = 0;
    for (int k = 0; k < side * side; ++k) {
        const vec2 at{(2 * (k % side) + 1.0) / side - 1, (2 * (k / side) + 1.0) / side - 1};
        const vec3 to = quad.center + at.x * quad.u + at.y * quad.v - p;
        const Real square = dot(to, to);
        angle += area(lamp) / (side * side) * std::max<Real>(-dot(n, to), 0) / (square * std::sqrt(square));
    }
    return std::min<Real>(angle / (4 * pi), 0.5);
}

/// The variance of the light that a random direction finds at places below the surface of bodies whose scatterings
/// shadow rays can leave. Lamps stand out against the environment.
Real noise_in_media(const Scene& scene, const std::vector<Emitter>& lamps) {
    const std::vector<Body> bodies = scattering_bodies(scene);
    const std::size_t step = 1 + std::size_t(Real(bodies.size() * lamps.size()) * 6 * 16 / most_work);
    const Real around = sum(scene.environment);
    Real noise = 0, all = 0;
    for (std::size_t k = 0; k < bodies.size(); k += step) {
        if (!goes_straight_through(*bodies[k].material)) continue;
        const vec3 center = (bodies[k].box.low + bodies[k].box.high) / 2.0, half = bodies[k].box.high - center;
        for (int side = 0; side < 6; ++side) {
            vec3 place = center;
            place[side / 2] += (side % 2 ? 0.8 : -0.8) * half[side / 2];
            Real mean = around;
            for (const Emitter& lamp : lamps) {
                const Real share = share_of_directions(lamp, place), brighter = sum(lamp.radiance) - around;
                mean += share * brighter, noise += share * (1 - share) * sqr(brighter);
            }
            all += sqr(mean);
        }
    }
    return all > 0 ? noise / all : 0;
}

Emitter emitter_of(const Scene& scene, int lamp) {
    const Shape& shape = scene.shapes[std::size_t(lamp)];
    Emitter emitter;
    if (const auto* quad = std::get_if<Quad>(&shape.geometry)) emitter.quad = *quad;
    if (const auto* disc = std::get_if<Disc>(&shape.geometry)) emitter.kind = Emitter::Kind::disc, emitter.disc = *disc;
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry))
        emitter.kind = Emitter::Kind::sphere, emitter.sphere = *sphere;
    emitter.radiance = scene.materials[std::size_t(shape.material)].emission;
    return emitter;
}

/// A way that the scene asks for or forbids, or that the rule is for.
LampWays::Way way(std::optional<bool> said, bool rule, const std::string& why) {
    return {said.value_or(rule), said ? "the scene says so" : why};
}

}  // namespace

LampWays choose_ways(const Scene& scene, const std::vector<int>& lamps) {
    Noise noise;
    std::vector<Emitter> emitters;
    for (const int lamp : lamps) emitters.push_back(emitter_of(scene, lamp));
    if (!scene.solid_angle || !scene.multiple_importance || !scene.one_lamp) noise = noise_of(scene, emitters);
    LampWays ways;
    const Real most = worth_one_lamp * Real(lamps.size()) * noise.of_all;
    const bool several = lamps.size() >= fewest_to_choose;
    const bool many = lamps.size() > most_to_take;
    ways.one_lamp =
        way(scene.one_lamp, many || (several && noise.of_one < most),
            many      ? fmt::format("there are more than {}", most_to_take)
            : several ? fmt::format("of one a variance of {:.2g}; worth it up to {:.2g}", noise.of_one, most)
                      : fmt::format("worth it from {} lamps", fewest_to_choose));
    const Real least = ways.one_lamp.on ? worth_solid_angle_of_one : worth_solid_angle,
               least_of_lobes = ways.one_lamp.on ? worth_weighing_one : worth_weighing * Real(lamps.size());
    ways.solid_angle = way(scene.solid_angle, noise.by_area > least,
                           fmt::format("by area a variance of {:.2g} more; worth it from {:g}", noise.by_area, least));
    ways.multiple_importance =
        way(scene.multiple_importance, noise.by_lobes > least_of_lobes,
            fmt::format("without, a variance of {:.2g} more; worth it from {:.2g}", noise.by_lobes, least_of_lobes));
    const Real in_media = scene.media_lit ? 0 : noise_in_media(scene, emitters),
               least_in_media =
                   ways.one_lamp.on ? worth_lighting_media_by_one : worth_lighting_media * Real(lamps.size());
    ways.media_lit =
        way(scene.media_lit, in_media > least_in_media,
            fmt::format("without, a variance of {:.2g} more; worth it from {:.2g}", in_media, least_in_media));
    return ways;
}

}  // namespace rt
