#include "asked/light_sample.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

/// A light of each kind, of about that size, that shines on the point p.
Emitter light_of(Emitter::Kind kind, double size, vec3 center, vec3 towards) {
    const rt::Frame frame = rt::frame_about(towards);
    Emitter light;
    light.kind = kind;
    light.quad = {center, size * frame.x, 0.5 * size * frame.y};
    light.disc = {center, towards, size};
    light.sphere = {center, size};
    return light;
}

/// The mean over the unit square of 1/density, which is the solid angle of the light, times the value of each sample.
template <class Value>
double mean_over_density(const Emitter& light, vec3 p, int n, const Asker& ask, Value value) {
    double sum = 0;
    for (const Row& out : ask.probe("light_sample", rows_at(grid(n), [&](vec2 u) { return row(light, p, u); }))) {
        const LightSample sample = from_row<LightSample>(out);
        if (std::isnan(sample.density) || std::isnan(sample.distance) || std::isnan(dot(sample.direction, vec3(1))))
            return rt::inf;
        if (sample.density > 0) sum += value(sample) / sample.density;
    }
    return sum / (n * n);
}

/// The solid angle of a sphere whose surface is so far away, in radii.
double solid_angle(double gap) {
    const long double s = 1 / (1 + (long double)gap);
    return double(2 * (long double)rt::pi * (s * s / (1 + std::sqrt((1 - s) * (1 + s)))));
}

/// Spheres from x radii away: their solid angle.
double sphere_gap(double x, Generator& random, const Asker& ask) {
    double worst = 0;
    for (int i = 0; i < 3; ++i) {
        const double radius = log_between(random, 0.5, 2);
        const vec3 p = box(random, -1, 1), to = direction(random);
        const Emitter light = light_of(Emitter::Kind::sphere, radius, p + radius * (1 + x) * to, -to);
        const double seen = mean_over_density(light, p, 32, ask, [](const LightSample&) { return 1.0; });
        worst = worse_error(worst, std::abs(seen / solid_angle(x) - 1));
    }
    return worst;
}

/// Samples of spheres from x radii away: on the sphere, in proportion to the distance.
double sphere_point(double x, Generator& random, const Asker& ask) {
    const Rows rows = rows_of(200, [=](Generator& draw) {
        const double radius = log_between(draw, 0.5, 2);
        const vec3 p = box(draw, -1, 1), to = direction(draw);
        return row(light_of(Emitter::Kind::sphere, radius, p + radius * (1 + x) * to, -to), p, square(draw));
    })(random);
    return worst_of<rt::light_sample>(
        ask, "light_sample", rows, [=](const LightSample& sample, const Emitter& light, vec3 p, vec2) {
            if (sample.density == 0) return 0.0;
            using Long = glm::vec<3, long double>;
            const Long from_center = Long(p) - Long(light.sphere.center);
            const Long off = from_center + (long double)sample.distance * Long(sample.direction);
            const double distance = light.sphere.radius * (1 + x);
            return double(std::abs(glm::length(off) - light.sphere.radius)) / distance;
        });
}

/// A flat light at x times its size, head on: the irradiance by it.
auto flat_gap(Emitter::Kind kind) {
    return [=](double x, Generator& random, const Asker& ask) {
        const double size = log_between(random, 0.5, 2), h = x * size;
        const vec3 p = box(random, -1, 1), n = direction(random);
        const double seen = mean_over_density(light_of(kind, size, p + h * n, -n), p, 48, ask,
                                              [&](const LightSample& s) { return dot(s.direction, n); });
        // of a quad, all distances count as equal
        const double truth = kind == Emitter::Kind::disc ? rt::pi / (1 + x * x) : 2 / (x * x);
        return std::abs(seen / truth - 1);
    };
}

/// Light and surface x times as large: the same directions and densities as at 1.
double light_size(double x, Generator& random, const Asker& ask) {
    Rows one, many;
    for (int i = 0; i < 90; ++i) {
        const auto kind = Emitter::Kind(i % 3);
        const vec3 center = box(random, -1, 1), towards = direction(random),
                   p = center + 3.0 * tilted(random, towards, between(random, 0, 1));
        const double size = log_between(random, 0.3, 1);
        const vec2 u = square(random);
        one.push_back(row(light_of(kind, size, center, towards), p, u));
        many.push_back(row(light_of(kind, x * size, x * center, towards), x * p, u));
    }
    const Rows base = ask.probe("light_sample", one);
    return worst_of_rows(ask, "light_sample", many, [&](std::size_t i, const Row& out) {
        const LightSample a = from_row<LightSample>(base[i]), b = from_row<LightSample>(out);
        const double density = a.density > 0 ? std::abs(b.density / a.density - 1) : std::abs(b.density);
        return worse_error(
            density, worse_error(rt::largest(b.direction - a.direction), std::abs(b.distance / x / a.distance - 1)));
    });
}

}  // namespace

std::vector<Family> light_families() {
    constexpr double u = rt::roundoff;
    return {
        Family("sphere_light_far", {"light_sample"}, "distance of a sphere light / its radius",
               "error of its solid angle",
               {.tolerance = 0.05, .bound = 0.05, .decades = sweep(0, 14), .scored = {0, 3}}, sphere_gap),
        Family("sphere_light_near", {"light_sample"}, "gap to a sphere light / its radius", "error of its solid angle",
               {.tolerance = 0.05, .bound = 0.05, .decades = sweep(-13, 0), .scored = {0, 0}}, sphere_gap),
        Family("sphere_light_point", {"light_sample"}, "gap to a sphere light / its radius",
               "distance of a sample from the light / distance",
               {.bound = 1e-9, .decades = sweep(-13, 14), .scored = {0, 3}}, sphere_point),
        Family("quad_light_far", {"light_sample"}, "distance of a quad light / its size", "error of its irradiance",
               {.tolerance = 0.05, .bound = 0.05, .decades = sweep(1, 20), .scored = {1, 3}},
               flat_gap(Emitter::Kind::quad)),
        Family("disc_light_far", {"light_sample"}, "distance of a disc light / its radius", "error of its irradiance",
               {.tolerance = 0.05, .bound = 0.05, .decades = sweep(0, 20), .scored = {0, 3}},
               flat_gap(Emitter::Kind::disc)),
        Family("light_size", {"light_sample"}, "size of light and scene [m]", "error against that at 1 m",
               {.bound = 256 * u, .decades = sweep(-60, 60, 3)}, light_size)};
}

}  // namespace grade::stress
