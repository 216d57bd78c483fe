#include "rt/calls.h"

#include <algorithm>

namespace rt {

std::vector<Calls> calls_of(const RenderPlan& plan) {
    std::vector<Calls> all;
    const auto stage = [&](const char* name) { all.push_back({name, {}}); };
    const auto call = [&](const char* fragment, bool called) {
        if (called) all.back().fragments.push_back(fragment);
    };
    const bool cells = plan.sampling.sampler == Sampler::uniform || plan.sampling.sampler == Sampler::stratified;
    const bool reflects = plan.diffuse || plan.phong, lamps = plan.light && (reflects || plan.weigh),
               follows = plan.mirrors || plan.glass || plan.glossy || plan.translucent;

    stage("camera");
    call("film_sample", plan.pixel);
    call("camera_ray", true);
    call("lens_ray", plan.lens);
    call("shutter_time", plan.time);
    stage("nearest");
    call("hit_sphere", plan.spheres);
    call("hit_triangle", plan.triangles);
    call("hit_quad", plan.quads);
    call("moved", plan.time);
    stage("medium");
    call("free_flight", plan.medium);
    call("scatter_direction", plan.medium);
    call("light_sample", plan.media_lit);
    call("shadow_ray", plan.media_lit);
    stage("surface");
    call("moved", plan.time);
    stage("emission");
    call("emission_counts", plan.counts_twice);
    stage("direct");
    call("point_irradiance", plan.point_lights && reflects);
    call("phong", plan.ambient || (plan.point_lights && plan.phong));
    call("light_sample", lamps);
    call("direct_light", lamps && reflects);
    call("cosine_hemisphere", plan.environment_lit);
    call("shadow_ray", (plan.point_lights && reflects) || lamps || plan.environment_lit);
    stage("scatter");
    call("whitted", follows);
    call("fresnel_dielectric", plan.glass || plan.translucent);
    call("mirror_direction", plan.mirrors);
    call("refracted_direction", plan.glass);
    call("glossy_reflection", plan.glossy);
    call("translucency", plan.translucent);
    call("color_bleeding", plan.bounce);
    stage("film");
    call("pixel_mean", plan.pixel);
    // whichever stage draws two numbers at once; those for the film are film_sample's
    stage("patterns");
    const std::vector<DrawnDimension> wave = wave_drawn(plan);
    const bool pairs = std::any_of(wave.begin(), wave.end(), [](const DrawnDimension& d) { return d.numbers == 2; });
    call("stratified_2d", cells && (plan.lens || pairs));
    return all;
}

}  // namespace rt
