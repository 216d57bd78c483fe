/// Many terms, many pixels, few pixels: extremes.md 40, 44, 45.

#include <set>

#include "extremes/transform.h"
#include "rt/fragments.h"
#include "rt/path.h"
#include "rt/sampler.h"

using namespace rt;

TEST_CASE("40 8192 x 8192 pixels with 64 samples: no number wraps at 32 bits", "[extremes]") {
    Camera camera;
    camera.size = {8192, 8192};
    // Pixels whose numbers differ by 2^32 samples, and neighbours across rows: all keys are different.
    for (const Sampler sampler : {Sampler::sobol, Sampler::blue_noise}) {
        std::set<Bits> keys;
        std::size_t pixels = 0;
        for (const int y : {0, 1, 4095, 4096, 8190, 8191})
            for (int x = 0; x < 8192; ++x) keys.insert(pixel_key(0, 8192, x, y, sampler)), ++pixels;
        CHECK(keys.size() == pixels);
        CHECK(pixel_key(0, 65536, 0, 0, sampler) != pixel_key(0, 65536, 0, 65535, sampler));
        CHECK(pixel_key(0, 65536, 1, 0, sampler) != pixel_key(0, 65536, 65535, 65535, sampler));
    }

    // The last pixels of the large film, with all their samples: the floor there, and the film's far corner is where it
    // is.
    Scene scene = small_scene("hit_quad");
    scene.camera.size = {8192, 8192};
    scene.samples = 64;
    const Rendering part = render(scene, {.samples = 64, .crop = Crop{8176, 8176, 16, 16}});
    CHECK(!part.bad_sample);
    CHECK(part.rays[int(RayKind::camera)] >= 16u * 16 * 64);
    const Ray corner = camera_ray(scene.camera, {8192, 8192}), opposite = camera_ray(scene.camera, {0, 0});
    CHECK(dot(corner.direction, scene.camera.right) ==
          Approx(-dot(opposite.direction, scene.camera.right)).epsilon(1e-14));

    // The bounds in which the framework counts: samples to 2^30, pixels to 2^28, paths to 2^20 are within their types.
    STATIC_REQUIRE(sizeof(Index) == 8);
    STATIC_REQUIRE(sizeof(RayCounts::value_type) == 8);
    STATIC_REQUIRE(sizeof(Rendering::samples) == 8);
    CHECK(Image(3, 5).pixels.size() == 15);
}

TEST_CASE("40 the whole film of 8192 x 8192 with 64 samples", "[extremes]") {
    if (!long_run()) return;
    Scene scene = plain_scene();
    scene.background = Color(1);
    scene.shapes.push_back({Sphere{{0, 0, -1e6}, 1}, 0, vec3(0)});
    const RenderSettings settings{.samples = 64, .estimate_error = false};
    scene.camera.size = {8192, 8192};
    const Rendering whole = render(scene, settings);
    figure(40, "camera rays of 8192 x 8192 x 64 that are missing", double((std::uint64_t(1) << 32) - whole.rays[0]), 0);
    std::int64_t dark = 0;
    for (const Color& c : whole.image.pixels) dark += c.x < 0.9;
    figure(40, "pixels that were not drawn, beside those of a far ball", double(dark), 16);
}

TEST_CASE("44 1 sample, 7 samples, images of 1 x 1 and 1 x 65536", "[extremes]") {
    for (const std::string name : {"whitted", "depth_of_field", "color_bleeding"})
        for (const Sampler sampler : {Sampler::uniform, Sampler::random, Sampler::stratified, Sampler::sobol})
            for (const int samples : {1, 7})
                for (const ivec2 size : {ivec2(1, 1), ivec2(1, 3), ivec2(5, 1)}) {
                    Scene scene = small_scene(name);
                    scene.camera.size = size;
                    scene.samples = samples;
                    scene.sampler = sampler;
                    const Image image = picture(scene);
                    REQUIRE(image.pixels.size() == std::size_t(size.x) * std::size_t(size.y));
                }
    for (const ivec2 size : {ivec2(1, 65536), ivec2(65536, 1)}) {
        Scene scene = small_scene("hit_sphere");
        scene.camera.size = size;
        scene.samples = 1;
        const Image image = picture(scene);
        CHECK(image.pixels.size() == 65536);
    }
}

TEST_CASE("45 1e8 accumulations: relative 1e-12", "[extremes]") {
    // Terms of all sizes, and of one size where each rounding goes the same way.
    Random random(45);
    Sum constant, mixed;
    const std::int64_t n = 100000000;
    for (std::int64_t i = 0; i < n; ++i) constant.add(0.1);
    figure(45, "sum of 1e8 tenths, relative", std::abs(constant.value() / (0.1 * n) - 1), 1e-12);
    long double exact = 0;
    for (std::int64_t i = 0; i < n / 4; ++i) {
        const Real x = 1.0 / Real(i + 1);
        mixed.add(x), exact += (long double)(x);
    }
    figure(45, "harmonic sum of 2.5e7 terms, relative", double(std::abs(mixed.value() / exact - 1)), 1e-12);

    // The fragments: a pixel, and the sums of part 1.
    const std::vector<Color> radiance(4000000, Color(0.1, 1e30, 1e-30));
    const std::vector<Real> weight(radiance.size(), 1);
    const Color mean = pixel_mean(radiance, weight);
    figure(45, "mean of 4e6 equal samples, relative",
           std::max({std::abs(mean.x / 0.1 - 1), std::abs(mean.y / 1e30 - 1), std::abs(mean.z / 1e-30 - 1)}), 1e-12);
    const int points = int(count_of(1e7, 1e8));
    const Real tenth = integrate_uniform([](Real) { return 0.1; }, 0, 1, points);
    figure(45, "integrate_uniform with " + std::to_string(points) + " points, relative", std::abs(tenth / 0.1 - 1),
           1e-12);

    // Passes that follow each other: each adds a little to a long sum.
    Scene scene;
    scene.background = Color(0.1, 0.2, 0.3);  // every pass is the same
    scene.camera.size = {1, 1};
    RenderSettings settings{.samples = 1, .threads = 1, .estimate_error = false, .time_limit = 1};
    const Rendering many = render(scene, settings);
    settings.time_limit = inf;
    const Color one = render(scene, settings).image.pixels[0];
    CHECK(many.samples > 100);
    figure(45, "mean of many passes against one, relative", largest(many.image.pixels[0] - one) / largest(one),
           2 * roundoff);
}
