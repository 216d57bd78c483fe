#include "catch.h"

#include "rt/files/scene_reader.h"
#include "rt/render.h"

namespace {

/// A floor in fog that swallows all that it meets, under a small ball that shines; one pixel looks at the point below
/// it.
constexpr const char* fog = R"(
[render]
samples = 262144
[camera]
eye = [3, 0, 4]
target = [0, 0, 0]
vfov = 0.001
size = [1, 1]
[materials.fog]
transmittance = 1
medium = { extinction = 0.7, albedo = 0 }
[materials.floor]
albedo = 0.5
[materials.lamp]
emission = 10
[[shape]]
type = "sphere"
center = [0, 0, 0]
radius = 3
material = "fog"
[[shape]]
type = "disc"
center = [0, 0, 0]
normal = [0, 0, 1]
radius = 1
material = "floor"
[[shape]]
type = "sphere"
center = [0, 0, 1]
radius = 0.2
material = "lamp"
)";

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
    rt::RenderSettings settings;
    settings.samples = scene.samples;
    settings.sampler = rt::Sampler::random;
    const rt::Rendering r = rt::render(scene, settings);
    const double value = r.image.at(0, 0).x, share = std::exp(-s * 3);
    // Standard error: of the share of paths that survive, in the main.
    const double error = expected * std::sqrt((1 - share) / share / scene.samples);
    CAPTURE(value, expected, error);
    CHECK(std::abs(value - expected) < 4 * error);
}
