#include "checks/light_sample/checks.h"

namespace grade::light_sample {

using rt::Emitter, rt::LightSample, rt::vec3;

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

}  // namespace grade::light_sample
