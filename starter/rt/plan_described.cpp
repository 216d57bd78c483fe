#include <fmt/format.h>
#include <fmt/ranges.h>

#include "rt/calls.h"
#include "rt/plan.h"

/// The plan in words. What it decides is in plan.cpp.
namespace rt {
namespace {

/// A line of the plan's table: what, whether it is on, and how so or why not.
std::string row(const char* what, bool on, const std::string& yes, const std::string& no) {
    return fmt::format("  {:<14} {:<4} {}\n", what, on ? "on" : "-", on ? yes : no);
}

/// How lamps are sampled, and why.
std::string describe_lamps(const RenderPlan& plan) {
    const LampWays& ways = plan.ways;
    const bool several = plan.light && plan.lamps.size() > 1;
    return row("solid angle", plan.solid_angle, "of quads: " + ways.solid_angle.why,
               plan.quad_lamps ? "quads by area: " + ways.solid_angle.why : "no quad that is sampled") +
           row("one lamp", plan.one_lamp, "chosen at each point: " + ways.one_lamp.why,
               several ? "all at each point: " + ways.one_lamp.why : "no two lamps") +
           row("weigh", plan.weigh, "lamps against glossy lobes: " + ways.multiple_importance.why,
               plan.lit.lobes ? "lobes alone find lamps: " + ways.multiple_importance.why
                              : "no glossy lobe, or no emitter") +
           row("media lit", plan.media_lit, "lamps against scatterings: " + ways.media_lit.why,
               plan.lit.media ? "paths alone find lamps: " + ways.media_lit.why
                              : "no medium that scatters behind a boundary of ior 1, or no emitter");
}

std::string describe_integrals(const RenderPlan& plan, const Scene& scene) {
    const Sampling& sampling = plan.sampling;
    return "integrals\n" +
           row("pixel", plan.pixel,
               sampling.passes ? "pass after pass, until a limit" : fmt::format("{} samples a pixel", sampling.samples),
               "one sample a pixel, through its centre") +
           row("lens", plan.lens, fmt::format("radius {:g} m", scene.camera.lens_radius), "a pinhole") +
           row("time", plan.time, fmt::format("{:g} s to {:g} s", scene.shutter.open, scene.shutter.close),
               "nothing moves while the shutter is open") +
           row("light", plan.light, fmt::format("{} emitters", plan.lamps.size()),
               "no emitter that lights a diffuse surface or a medium") +
           describe_lamps(plan) +
           row("environment", plan.environment_lit,
               plan.sky_by_bounces ? "found by what bounces; by shadow rays where nothing bounces any more"
                                   : "lights the diffuse surfaces",
               "no environment that lights a diffuse surface") +
           row("lobe", plan.lobe, "glossy or translucent surfaces", "no glossy or translucent surface") +
           row("bounce", plan.bounce, fmt::format("up to {}", scene.bounces),
               "no diffuse surface, or no bounces asked for") +
           row("medium", plan.medium, "random walks", "no medium") +
           row("through", plan.through, "shadow rays go through boundaries of ior 1",
               "no such boundary, or no shadow ray") +
           row("roulette", plan.roulette, "paths that carry little end at random: " + plan.ends_early, plan.ends_early);
}

std::string describe_stages(const RenderPlan& plan, const Scene& scene) {
    std::size_t triangles = 0;
    for (const Mesh& mesh : scene.meshes) triangles += mesh.triangles.size();
    return "stages\n" + row("camera", true, plan.lens ? "through the lens" : "through the pinhole", "") +
           row("nearest", true,
               fmt::format("{} shapes, {} triangles in meshes, {}", scene.shapes.size(), triangles,
                           plan.bvh ? "in a tree" : "one by one"),
               "") +
           row("medium", plan.medium, "", "no medium") +
           row("surface", plan.spheres || plan.triangles || plan.quads || plan.discs,
               plan.checker ? "with checkers" : "", "nothing to hit") +
           row("emission", plan.emission || plan.environment || scene.background != Color(0),
               plan.counts_twice ? "what shadow rays have gathered counts once"
               : plan.media_lit  ? "what media find is weighed; nothing bounces"
                                 : "all that is seen counts: nothing bounces",
               "nothing shines that a ray can hit") +
           row("direct", plan.point_lights || plan.light || plan.environment_lit || scene.ambient != Color(0),
               fmt::format("{} lights without extent, {} with", scene.lights.size(),
                           plan.light ? plan.lamps.size() : 0),
               "no lights") +
           row("scatter", plan.specular || plan.lobe || plan.bounce,
               plan.split    ? "mirror and glass rays are both followed"
               : plan.choice ? "one way on is chosen at random"
                             : "one way on",
               "no ray goes on: a single wave") +
           row("film", plan.pixel, "the mean of the samples", "the sample is the pixel");
}

/// The dimensions of one sample that are drawn, and the rays.
std::string describe_costs(const RenderPlan& plan, const Scene& scene) {
    const Sampling& sampling = plan.sampling;
    const auto numbers = [](const std::vector<DrawnDimension>& drawn) {
        int sum = 0;
        for (const DrawnDimension& d : drawn) sum += d.numbers;
        return sum;
    };
    const int lamps = plan.light ? plan.one_lamp ? 1 : int(plan.lamps.size()) : 0;
    const std::string text = fmt::format("dimensions       {} for the camera, {} for each wave\n",
                                         numbers(camera_drawn(plan)), numbers(wave_drawn(plan)));
    const int waves = 1 + (plan.bounce ? scene.bounces : 0), of_sky = plan.sky_by_bounces ? 1 : waves;
    const std::size_t shadow =
        (scene.lights.size() + std::size_t(lamps)) * std::size_t(waves) + std::size_t(plan.environment_lit * of_sky);
    const int samples = sampling.passes ? 1 : sampling.samples;
    return text +
           fmt::format("rays per {:<7} {} camera, at most {} shadow where no path meets mirrors, glass or media\n",
                       sampling.passes ? "sample" : "pixel", samples, std::size_t(samples) * shadow);
}

}  // namespace

std::string describe(const RenderPlan& plan, const Scene& scene) {
    std::string text = describe_integrals(plan, scene) + describe_stages(plan, scene) + describe_costs(plan, scene);
    text += "fragments that the stages call\n";
    for (const Calls& calls : calls_of(plan))
        if (!calls.fragments.empty())
            text += fmt::format("  {:<14} {}\n", calls.stage, fmt::join(calls.fragments, ", "));
    return text;
}

}  // namespace rt
