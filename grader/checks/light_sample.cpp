#include "asked/light_sample.h"
#include "checks/kit/shadow_scene.h"
#include "checks/kit/warp.h"
#include "statistics/closed_forms.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

/// The point of a flat light in units of its half edges or its radius, across and along.
vec2 on_light(const Emitter& light, vec3 p, const LightSample& s) {
    const vec3 q = p + s.distance * s.direction - rt::center(light);
    if (light.kind == Emitter::Kind::quad)
        return {rt::dot(q, light.quad.u) / rt::dot(light.quad.u, light.quad.u),
                rt::dot(q, light.quad.v) / rt::dot(light.quad.v, light.quad.v)};
    const rt::Frame frame = rt::frame_about(light.disc.normal);
    return vec2(rt::dot(q, frame.x), rt::dot(q, frame.y)) / light.disc.radius;
}

/// Area that a sample stands for: distance^2 / (cosine at the light * density). Its mean is the light's area, whatever
/// the density, if that is the density of the sample.
double area_share(const LightSample& s, const Emitter& light) {
    if (!(s.density > 0)) return 0;
    const double cosine = -rt::dot(s.direction, rt::unit(rt::normal(light)));
    return cosine > 1e-9 ? rt::sqr(s.distance) / (cosine * s.density) : 0;
}

/// How far a sample is off the light's surface, in the light's size.
double off_light(const LightSample& s, const Emitter& light, vec3 p, vec2) {
    if (!(s.density > 0)) return s.density == 0 ? 0 : rt::inf;
    if (std::abs(glm::length(s.direction) - 1) > 1e-4) return rt::inf;
    const vec3 q = p + s.distance * s.direction - rt::center(light);
    if (light.kind == Emitter::Kind::sphere) {
        const double off = std::abs(glm::length(q) / light.sphere.radius - 1);
        return rt::dot(q, s.direction) > 1e-3 * light.sphere.radius ? rt::inf : off;  // the near side alone is seen
    }
    const vec2 at = on_light(light, p, s);
    const double size = std::sqrt(rt::area(light)),
                 off_plane = std::abs(rt::dot(q, rt::unit(rt::normal(light)))) / size;
    const double beyond =
        light.kind == Emitter::Kind::quad ? std::max(std::abs(at.x), std::abs(at.y)) - 1 : std::hypot(at.x, at.y) - 1;
    return std::max({off_plane, beyond, 0.0});
}

Statistic samples_on_light(const std::string& unit, const std::string& says) {
    return property({.id = "L1",
                     .what = "distance of the samples from the light, in its " + unit,
                     .violation = of_call<rt::light_sample>(off_light),
                     .tolerance = 1e-3,
                     .says = says});
}

Emitter emitter(Generator& random, Emitter::Kind kind) {
    Emitter light;
    light.kind = kind;
    const rt::Frame frame = rt::frame_about(direction(random));
    light.quad = {box(random, -1, 1), between(random, 0.2, 0.6) * frame.x, between(random, 0.2, 0.6) * frame.y};
    light.disc = {box(random, -1, 1), frame.z, between(random, 0.2, 0.6)};
    light.sphere = {box(random, -1, 1), between(random, 0.3, 0.8)};
    return light;
}

std::function<Rows(Generator&)> samples_of(const Emitter& light, vec3 p, int side) {
    return with_repeats(rows_over_square(side, [=](vec2 u) { return row(light, p, u); }));
}

/// The mean of f(point on the light) over its area.
template <class F>
RowNumber moment_on_light(F f) {
    return of_call<rt::light_sample>([f](const LightSample& s, const Emitter& light, vec3 p, vec2) {
        const double share = area_share(s, light);
        return share > 0 ? share * f(on_light(light, p, s)) : 0.0;
    });
}

std::string one_point(const Observation& seen) {
    const LightSample first = result<rt::light_sample>(seen.outputs[0]);
    for (const Row& out : seen.outputs)
        if (glm::length(result<rt::light_sample>(out).direction - first.direction) > 1e-9) return "";
    return "one point of the light is taken for all samples: u must choose it";
}

/// Where on a flat light samples are: their mean, and their mean squares.
std::vector<Statistic> places_on_light(double area, bool quad) {
    const auto mean = [&](const std::string& axis, int k) {
        return mean_of({.id = "L3",
                        .what = "mean point on the light, " + axis,
                        .number = moment_on_light([=](vec2 q) { return q[k] / area; }),
                        .truth = 0,
                        .hint =
                            [](double value, double) {
                                return std::string(
                                    std::abs(value) > 0.05
                                        ? "the light is sampled from its corner, or one half of it more than the other"
                                        : "one side of the light is sampled more than the other");
                            },
                        .cause = one_point});
    };
    const auto mean_square = [&](const std::string& axis, int k) {
        return mean_of(
            {.id = "L3",
             .what = "mean square of the point on the light, " + axis,
             .number = moment_on_light([=](vec2 q) { return q[k] * q[k]; }),
             .truth = area / (quad ? 3 : 4),
             .hint = by_ratio("the mean square of the point on the light",
                              {{1.0 / 16, quad ? "u and v are half edges, which are used as whole ones"
                                               : "the radius is used as the diameter"},
                               {16, quad ? "u and v are half edges already" : "the diameter is used as the radius"},
                               {0.25, "half of the light is sampled"},
                               {0, "one point of the light is sampled"},
                               {2.0 / 3, "points crowd in the middle: is a square root missing?"}}),
             .cause = one_point});
    };
    const Statistic covariance =
        mean_of({.id = "L3",
                 .what = "covariance of the point on the light",
                 .number = moment_on_light([=](vec2 q) { return q.x * q.y / area; }),
                 .truth = 0,
                 .hint = always("the two coordinates depend on each other: one needs u.x and the other u.y")});
    return {mean("across", 0), mean("along", 1), mean_square("across", 0), mean_square("along", 1), covariance};
}

Check flat_light(Generator& random, Emitter::Kind kind, const char* name) {
    const Emitter light = emitter(random, kind);
    const bool quad = kind == Emitter::Kind::quad;
    const vec3 p = rt::center(light) +
                   between(random, 1, 3) * tilted(random, rt::unit(rt::normal(light)), between(random, 0.2, 0.8));
    const double area = rt::area(light);
    const Statistic on = samples_on_light(
        "size", quad ? "samples lie beside the light: its points are center + x u + y v with |x|, |y| <= 1, at "
                       "`distance` along the unit direction"
                     : "samples lie beside the light: its points are within the radius of the centre, at `distance` "
                       "along the unit direction");
    const Statistic size = find_half_a_percent(mean_of(
        {.id = "L1",
         .what = "light gathered, as an area [m2]",
         .number = moment_on_light([](vec2) { return 1.0; }),
         .truth = area,
         .hint = by_ratio(
             "the light that is gathered",
             {{0.25, quad ? "u and v are half edges: the area is 4 |u x v|" : "is the radius used as the diameter?"},
              {4, "the density is that of an area 4 times too large"},
              {1 / area, "the light's area is missing from the density"},
              {2, "is a density halved?"},
              {0.5, "is a density doubled?"},
              {rt::pi, "is a factor pi missing from the area?"}},
             "is the density per solid angle, distance^2 / (cosine at the light * area)?"),
         .cause = one_point}));
    std::vector<Statistic> statistics = places_on_light(area, quad);
    statistics.insert(statistics.begin(), {on, size});
    statistics.push_back(purity());
    return probe_check(name, samples_of(light, p, 32), statistics);
}

Check sphere_light(Generator& random) {
    const Emitter light = emitter(random, Emitter::Kind::sphere);
    const double distance = light.sphere.radius * between(random, 1.5, 4);
    const vec3 axis = direction(random), p = light.sphere.center - distance * axis;
    const double sine = light.sphere.radius / distance, cap = 1 - std::sqrt(1 - sine * sine),
                 solid_angle = 2 * rt::pi * cap;
    const rt::Frame frame = rt::frame_about(axis);
    // mean of f / density is the integral of f over the directions towards the sphere
    const auto integral = [](auto f) {
        return of_call<rt::light_sample>(
            [f](const LightSample& s) { return s.density > 0 ? f(s.direction) / s.density : 0.0; });
    };
    const auto lean = [&](const std::string& way, vec3 across) {
        return mean_of({.id = "L1",
                        .what = "mean direction, " + way,
                        .number = integral([=](vec3 d) { return rt::dot(d, across) / (sine * solid_angle); }),
                        .truth = 0,
                        .hint = always("one side of the sphere is sampled more than the other")});
    };
    // half a percent would take hundreds of replicates where samples are spread over the whole sphere
    const Statistic size =
        mean_of({.id = "L1",
                 .what = "solid angle of the light [sr]",
                 .number = integral([](vec3) { return 1.0; }),
                 .truth = solid_angle,
                 .delta = 0.01 * solid_angle,
                 .hint = by_ratio("the solid angle",
                                  {{2, "is the density halved?"},
                                   {4 * rt::pi / solid_angle, "the density is that of all directions"}},
                                  "is the density the one of the directions that are returned?")});
    const Statistic height =
        mean_of({.id = "L1",
                 .what = "mean of 1 - cos(theta) about the axis, over its value",
                 .number = integral([=](vec3 d) { return (1 - rt::dot(d, axis)) * 2 / (cap * solid_angle); }),
                 .hint = by_ratio("the mean of 1 - cos(theta)", {{0, "one point of the light is sampled"}},
                                  "the sphere is not sampled evenly as seen from the point")});
    // more rows, for samples that are spread over the whole sphere: most of them are on its far side
    return probe_check(
        "sphere_light", samples_of(light, p, 64),
        {samples_on_light("radius",
                          "samples lie off the near side of the sphere, at `distance` along the unit direction"),
         size, height, lean("sideways", frame.x), lean("upwards", frame.y), purity()});
}

constexpr int layout_count = 48, samples_of_each = 16;

/// The powers of distance, cosine and area that the estimates of small lights at many places have left over; nan where
/// there is no light.
double leftover_power(const Observation& seen, std::size_t which) {
    std::vector<std::vector<double>> factors;
    std::vector<double> logs;
    for (int k = 0; k < layout_count; ++k) {
        double sum = 0;
        for (int i = 0; i < samples_of_each; ++i) {
            const LightSample s = result<rt::light_sample>(seen.outputs[k * samples_of_each + i]);
            if (s.density > 0) sum += 1 / s.density / samples_of_each;
        }
        const Row& in = seen.inputs[k * samples_of_each];
        const Emitter light = argument<rt::light_sample, 0>(in);
        const vec3 to = light.quad.center - argument<rt::light_sample, 1>(in);
        const double r = glm::length(to), cosine = -rt::dot(to, rt::unit(rt::normal(light))) / r;
        factors.push_back({1, std::log(r), std::log(cosine), std::log(rt::area(light))});
        logs.push_back(std::log(sum * r * r / (cosine * rt::area(light))));
        if (!std::isfinite(logs.back())) return NAN;
    }
    return least_squares(factors, logs)[which].value;
}

/// Small lights at many places: which powers of distance, cosine and area the estimate has.
Check layouts() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (int k = 0; k < layout_count; ++k) {
            Emitter light = emitter(random, Emitter::Kind::quad);
            light.quad.u *= 0.3, light.quad.v *= 0.3;
            const double angle = between(random, 0, 1.2);
            const vec3 p =
                light.quad.center + log_between(random, 1.5, 8) * tilted(random, rt::unit(rt::normal(light)), angle);
            for (int i = 0; i < samples_of_each; ++i) rows.push_back(row(light, p, square(random)));
        }
        return rows;
    };
    const auto power = [](std::size_t which, const std::string& of, const std::vector<KnownValue>& known,
                          const std::string& else_words) {
        return Statistic{.id = "L2",
                         .what = "power of the " + of + " that is left over",
                         .measure = [=](const Observation& seen) { return leftover_power(seen, which); },
                         .truth = 0,
                         .delta0 = 0.02,
                         .delta = 0.3,
                         .hint = [=](double value, double) -> std::string {
                             if (std::isnan(value)) return "the light gives no light where it must";
                             for (const KnownValue& k : known)
                                 if (std::abs(value - k.value) < 0.3) return k.words;
                             return else_words;
                         }};
    };
    return probe_check(
        "many_places", inputs,
        {power(1, "distance",
               {{2, "1/r^2 is missing: density per solid angle = density per area * distance^2 / cosine"},
                {1, "the distance counts once; expected squared"}},
               "the estimate has a wrong power of the distance"),
         power(2, "cosine at the light",
               {{-1,
                 "the cosine at the light is missing: density per solid angle = density per area * distance^2 / "
                 "cosine"}},
               "the cosine at the light has a wrong power: is the density multiplied where it must be divided?"),
         power(3, "area", {{-1, "the area is missing: the density per area is 1 / area"}},
               "the estimate has a wrong power of the light's area")});
}

/// Irradiance of a surface, against the formulas of Lambert and others: a quad anywhere, a disc that the surface faces,
/// a sphere.
Check irradiance(Generator& random) {
    const std::array lights = {emitter(random, Emitter::Kind::quad), emitter(random, Emitter::Kind::disc),
                               emitter(random, Emitter::Kind::sphere)};
    struct Surface {
        vec3 p, n;
    };
    std::array<Surface, 3> surfaces;
    const vec3 to_quad = tilted(random, rt::unit(rt::normal(lights[0])), between(random, 0, 0.6));
    surfaces[0] = {lights[0].quad.center + between(random, 1.2, 2) * to_quad,
                   tilted(random, -to_quad, between(random, 0.2, 0.5))};
    const double height = between(random, 0.5, 1.5), distance = lights[2].sphere.radius * between(random, 2, 3),
                 angle = between(random, 0.2, 0.8);
    surfaces[1] = {lights[1].disc.center + height * lights[1].disc.normal, -lights[1].disc.normal};
    const vec3 to_sphere = direction(random);
    surfaces[2] = {lights[2].sphere.center - distance * to_sphere, tilted(random, to_sphere, angle)};
    const double due[] = {quad_irradiance(lights[0].quad, surfaces[0].p, surfaces[0].n),
                          coaxial_disc_irradiance(lights[1].disc.radius, height),
                          sphere_irradiance(lights[2].sphere, surfaces[2].p, surfaces[2].n)};

    const auto inputs = [=](Generator& draws) {
        Rows rows;
        for (std::size_t k = 0; k < 3; ++k)
            for (Row& one : rows_over_square(40, [&](vec2 u) { return row(lights[k], surfaces[k].p, u); })(draws))
                rows.push_back(std::move(one));
        return rows;
    };
    std::vector<Statistic> statistics;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string name = std::array{"a quad", "a disc that faces it", "a sphere"}[k];
        // three times the mean over all rows is the mean over those of one light
        const auto share = [kind = lights[k].kind, n = surfaces[k].n, all = due[k]](const LightSample& s,
                                                                                    const Emitter& light, vec3, vec2) {
            return light.kind == kind && s.density > 0 ? 3 * std::max(0.0, rt::dot(n, s.direction)) / s.density / all
                                                       : 0.0;
        };
        const Statistic mean = mean_of(
            {.id = "L1",
             .what = "irradiance of a surface by " + name + ", over what it must be",
             .number = of_call<rt::light_sample>(share),
             .delta = 0.01,
             .hint = by_ratio("the irradiance by " + name,
                              {{0.5, "is the density twice too large?"}, {2, "is the density twice too small?"}},
                              "is the density per solid angle that of the sample?")});
        statistics.push_back(k < 2 ? find_half_a_percent(mean) : mean);
    }
    return probe_check("irradiance", inputs, statistics);
}

/// Points behind a flat light get nothing.
Check dark_side() {
    const auto inputs = rows_of(64, [](Generator& random) {
        const Emitter light = emitter(random, chance(random, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
        const vec3 p = rt::center(light) -
                       between(random, 1, 3) * tilted(random, rt::unit(rt::normal(light)), between(random, 0, 1));
        return row(light, p, square(random));
    });
    return probe_check(
        "dark_side", inputs,
        {property({.id = "L4",
                   .what = "density behind the light",
                   .violation = of_call<rt::light_sample>([](const LightSample& s) { return std::abs(s.density); }),
                   .says = "the light shines backwards: behind a quad or a disc the density is 0"})});
}

/// Whether a light shines on a point: on those in front of a flat one, and outside of a sphere.
bool shines(const Emitter& light, vec3 p) {
    if (light.kind == Emitter::Kind::sphere) return glm::length(p - light.sphere.center) >= light.sphere.radius;
    return rt::dot(p - rt::center(light), rt::normal(light)) > 0;
}

/// Lamps from a centimetre to 100 m away, seen along an axis of the world or anyhow; flat ones from behind as well,
/// spheres from the inside, and so close that they fill half of the sky.
Check anywhere() {
    const auto flat = [](Generator& draw) {
        const Emitter light = emitter(draw, chance(draw, 0.5) ? Emitter::Kind::quad : Emitter::Kind::disc);
        const double side = chance(draw, 0.3) ? -1 : 1;
        const vec3 p = rt::center(light) + side * log_between(draw, 1, 100) *
                                               tilted(draw, rt::unit(rt::normal(light)), between(draw, 0, 1));
        return row(light, p, square(draw));
    };
    const auto sphere = [](Generator& draw) {
        const Emitter light = emitter(draw, Emitter::Kind::sphere);
        const vec3 away = chance(draw, 0.5) ? exact_direction(draw) : direction(draw);
        return row(light, light.sphere.center + light.sphere.radius * (1 + log_between(draw, 1e-2, 100)) * away,
                   square(draw));
    };
    const auto within = [](Generator& draw) {
        const Emitter light = emitter(draw, Emitter::Kind::sphere);
        return row(light, light.sphere.center + light.sphere.radius * between(draw, 0, 0.95) * direction(draw),
                   square(draw));
    };
    const Statistic dark =
        property({.id = "L4",
                  .what = "density behind a flat light, or within a sphere",
                  .violation = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                      return shines(light, p) ? 0.0 : std::abs(s.density);
                  }),
                  .says = "a light sends nothing to a point behind it, or within a sphere: the density is 0"});
    const Statistic on = property(
        {.id = "L1",
         .what = "distance of the samples from the light, in its size",
         .violation = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2 u) {
             return shines(light, p) ? off_light(s, light, p, u) : 0.0;
         }),
         .tolerance = 1e-2,
         .says = "samples lie off the light where it is near or far, or straight along an axis of the world"});
    const Statistic missing =
        mean_of({.id = "L1",
                 .what = "share of the samples in front of a flat light that count",
                 .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                     // of a sphere, samples may lie on its far side
                     const bool may_be_dark = light.kind == Emitter::Kind::sphere || !shines(light, p);
                     return may_be_dark || s.density > 0 ? 1.0 : 0.0;
                 }),
                 .delta0 = 0.001,
                 .delta = 0.01,
                 .hint = always("a point in front of a flat light gets no light, from 1 to 100 m away")});
    return probe_check("anywhere", rows_of_kinds(64, flat, sphere, within), {dark, on, missing});
}

/// The solid angle of spheres that fill up to half of the sky.
Check large_spheres() {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (const double sine : {0.3, 0.6, 0.8}) {
            Emitter light = emitter(random, Emitter::Kind::sphere);
            const vec3 p = light.sphere.center + light.sphere.radius / sine * direction(random);
            for (const Row& u : rows_over_square(24, [](vec2 u) { return row(u); })(random))
                rows.push_back(row(light, p, vec2(u[0], u[1])));
        }
        return rows;
    };
    return probe_check(
        "large_spheres", inputs,
        {mean_of({.id = "L1",
                  .what = "solid angle of spheres that fill up to half of the sky, over what it is",
                  .number = of_call<rt::light_sample>([](const LightSample& s, const Emitter& light, vec3 p, vec2) {
                      const double sine = light.sphere.radius / glm::length(p - light.sphere.center);
                      return s.density > 0 ? 1 / s.density / (2 * rt::pi * (1 - std::sqrt(1 - sine * sine))) : 0.0;
                  }),
                  .delta0 = 0.002,
                  .delta = 0.05,
                  .hint = by_ratio("the solid angle of large spheres", {{2, "is the density halved?"}},
                                   "is the sine of the cone the radius over the distance of the centre?")})});
}

}  // namespace

Checks check_light_sample(Generator& random) {
    using Kind = Emitter::Kind;
    Checks checks = {layouts(),
                     flat_light(random, Kind::quad, "quad_light"),
                     flat_light(random, Kind::disc, "disc_light"),
                     sphere_light(random),
                     anywhere(),
                     large_spheres(),
                     irradiance(random),
                     dark_side()};
    // half of all directions see a flat light from behind
    checks.back().share = 2;
    checks.push_back(shadow_check(random, "quad_penumbra", any_shadow(random, Kind::quad)));
    checks.push_back(shadow_check(random, "disc_penumbra", any_shadow(random, Kind::disc)));
    checks.push_back(shadow_check(random, "sphere_penumbra", any_shadow(random, Kind::sphere)));
    return checks;
}

}  // namespace grade
