#include "catch.h"

#include "rt/files/scene_reader.h"
#include "rt/render.h"
#include "scenes.h"

namespace {

/// A floor in fog that swallows all that it meets, under a small ball that shines; one pixel looks at the point below
/// it.
const std::string fog = scene_table("[render]", {{"samples", 262144}}) +
                        camera({3, 0, 4}, {0, 0, 0}, {{"vfov", 0.001}, {"size", "[1, 1]"}}) +
                        material("fog", {{"transmittance", 1}, {"medium", "{ extinction = 0.7, albedo = 0 }"}}) +
                        material("floor", {{"albedo", 0.5}}) + material("lamp", {{"emission", 10}}) +
                        sphere("fog", {0, 0, 0}, 3) + disc("floor", {0, 0, 0}, {0, 0, 1}, 1) +
                        sphere("lamp", {0, 0, 1}, 0.2);

}  // namespace

TEST_CASE("a medium dims the light that shadow rays gather inside it") {
    // Irradiance: L exp(-s t) cos over the cone of the ball, t the distance to its near side.
    const double s = 0.7, radius = 0.2;
    double irradiance = 0;
    const int n = 10000;
    const double low = std::sqrt(1 - radius * radius);  // cosine of the cone
    for (int i = 0; i < n; ++i) {
        const double c = low + (1 - low) * (i + 0.5) / n;
        const double t = c - std::sqrt(radius * radius - (1 - c * c));
        irradiance += 2 * rt::pi * (1 - low) / n * 10 * std::exp(-s * t) * c;
    }
    // The way to the camera: 3 m of fog, which a path survives with this probability.
    const double expected = irradiance * 0.5 / rt::pi * std::exp(-s * 3);

    const rt::Scene scene = rt::parse_scene(fog, "fog.toml");
    const rt::Rendering r = rt::render(scene, {.samples = scene.samples, .sampler = rt::Sampler::random});
    const double value = r.image.at(0, 0).x, share = std::exp(-s * 3);
    // Standard error: of the share of paths that survive, in the main.
    const double error = expected * std::sqrt((1 - share) / share / scene.samples);
    CAPTURE(value, expected, error);
    CHECK(std::abs(value - expected) < 4 * error);
}
