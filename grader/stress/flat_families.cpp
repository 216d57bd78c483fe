#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Quad, rt::Ray, rt::Triangle, rt::vec3;

/// Two half edges at right angles about a centre. As a quad, s and t of its points run from -1 to 1; as a triangle, it
/// is the half with s + t < 0.
struct Patch {
    vec3 center, u, v;

    Quad quad() const { return {center, u, v}; }
    Triangle triangle() const { return {center - u - v, center + u - v, center - u + v}; }
};

Patch patch(Generator& random, double size, double aspect) {
    const rt::Frame frame = rt::frame_about(direction(random));
    return {size * box(random, -1, 1), size * frame.x, size / aspect * frame.y};
}

/// Where a ray meets the plane of a patch: t in units of |direction|, and s and t of the point.
struct Truth {
    double t;
    Exact along_u, along_v;
};

Truth truth_of(const Patch& p, bool is_quad, const Ray& ray) {
    // a triangle's edges are those of its rounded corners
    const Triangle rounded = p.triangle();
    const Exact3 u = is_quad ? Exact3(p.u) : Exact(0.5) * (Exact3(rounded.b) - Exact3(rounded.a));
    const Exact3 v = is_quad ? Exact3(p.v) : Exact(0.5) * (Exact3(rounded.c) - Exact3(rounded.a));
    const Exact3 center = is_quad ? Exact3(p.center) : Exact3(rounded.a) + u + v;
    const Exact3 n = cross(u, v), d(ray.direction), o(ray.origin);
    const Exact t = dot(center - o, n) / dot(d, n);
    const Exact3 point = o + t * d - center;
    return {double(t), dot(point, cross(v, n)) / dot(u, cross(v, n)), dot(point, cross(u, n)) / dot(v, cross(u, n))};
}

/// How far inside a point is, in half edges; negative: outside.
double depth_in(const Truth& truth, bool is_quad) {
    const double s = double(truth.along_u), t = double(truth.along_v);
    return is_quad ? 1 - std::max(std::abs(s), std::abs(t)) : std::min({1 + s, 1 + t, -(s + t)});
}

struct Aim {
    double size = 1, length = 1;  // of patch and ray; of the direction
    double aspect = 1;
    double angle = 0;  // between ray and patch; 0: not small
    vec3 shift{0};     // of everything
};

/// 200 rays that hit or clearly miss a patch. The error of a hit is in proportion to its distance and to `forgiven`.
double error_of_patches(bool is_quad, const Aim& aim, double forgiven, Generator& random, const Asker& ask) {
    const char* fragment = is_quad ? "hit_quad" : "hit_triangle";
    std::vector<Patch> patches;
    std::vector<Ray> rays;
    Rows rows;
    while (rays.size() < 200) {
        Patch p = patch(random, aim.size, aim.aspect);
        p.center += aim.shift;
        const bool inside = chance(random, 0.6);
        const double s = between(random, -0.8, 0.8),
                     t = inside && !is_quad ? between(random, -0.9, -0.1 - s) : between(random, -0.8, 0.8);
        const vec3 target = p.center + s * p.u + (inside ? t : 3 + t) * p.v;
        const vec3 n = rt::unit(cross(p.u, p.v));
        vec3 d = tilted(random, n, between(random, 0, 1.3));
        if (aim.angle > 0) d = std::cos(aim.angle) * tilted(random, n, rt::pi / 2) + std::sin(aim.angle) * n;
        const Ray ray{target - between(random, 2, 5) * aim.size * d, aim.length * d, 0, rt::inf};
        const double margin = 0.02 + 256 * rt::roundoff * aim.aspect / (aim.angle > 0 ? aim.angle : 1);
        if (std::abs(depth_in(truth_of(p, is_quad, ray), is_quad)) < margin) continue;
        patches.push_back(p), rays.push_back(ray);
        rows.push_back(is_quad ? row(p.quad(), ray) : row(p.triangle(), ray));
    }
    return worst_of_rows(ask, fragment, rows, [&](std::size_t i, const Row& out) {
        const Truth truth = truth_of(patches[i], is_quad, rays[i]);
        const bool hit = depth_in(truth, is_quad) > 0;
        if (std::isnan(out.at(0)) || std::isfinite(out[0]) != hit) return rt::inf;
        return hit ? std::abs(out[0] - truth.t) * aim.length / (5 * aim.size) / forgiven : 0;
    });
}

}  // namespace

std::vector<Family> flat_families() {
    std::vector<Family> all;
    for (const bool quad : {true, false}) {
        const std::string shape = quad ? "quad" : "triangle", hit = "hit_" + shape;
        const auto add = [&](const std::string& suffix, const std::string& swept, const std::string& error,
                             const std::vector<int>& decades, Decades scored, Aim (*aim)(double x),
                             double (*forgiven)(double x)) {
            all.push_back(Family(shape + suffix, {hit}, swept, error,
                                 {.tolerance = 1e-7, .bound = 64 * rt::roundoff, .decades = decades, .scored = scored},
                                 [=](double x, Generator& random, const Asker& ask) {
                                     return error_of_patches(quad, aim(x), forgiven(x), random, ask);
                                 }));
        };
        const auto nothing = [](double) { return 1.0; };
        add(
            "_scale", "size of " + shape + " and ray [m]", "error of the hit / size", sweep(-60, 60, 3), {-3, 3},
            [](double x) { return Aim{.size = x}; }, nothing);
        add(
            "_direction", "length of the direction", "error of the hit", sweep(-12, 12), {-3, 3},
            [](double x) { return Aim{.length = x}; }, nothing);
        add(
            "_grazing", "angle between ray and " + shape, "error of the hit x angle", sweep(-12, -1), {-3, -1},
            [](double x) { return Aim{.angle = x}; }, [](double x) { return 1 / x; });
        add(
            "_far", "distance from the world's origin [m]", "error of the hit", sweep(0, 12), {0, 3},
            [](double x) { return Aim{.shift = x * vec3(0.7, -0.2, 0.5)}; }, nothing);
        add(
            "_needle", "length / width of the " + shape, "error of the hit / aspect", sweep(0, 12), {0, 3},
            [](double x) { return Aim{.aspect = x}; }, [](double x) { return x; });
    }
    return all;
}

}  // namespace grade::stress
