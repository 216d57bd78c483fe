#include "checks/kit/warp.h"
#include "checks/light_sample/checks.h"

namespace grade::light_sample {

namespace {

using rt::Emitter, rt::LightSample, rt::vec2, rt::vec3;

/// Area that a sample stands for: distance^2 / (cosine at the light * density). Its mean is the light's area, whatever
/// the density, if that is the density of the sample.
double area_share(const LightSample& s, const Emitter& light) {
    if (!(s.density > 0)) return 0;
    const double cosine = -rt::dot(s.direction, rt::unit(rt::normal(light)));
    return cosine > 1e-9 ? rt::sqr(s.distance) / (cosine * s.density) : 0;
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

}  // namespace

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

}  // namespace grade::light_sample
