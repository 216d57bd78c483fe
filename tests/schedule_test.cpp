#include "rt/passes/schedule.h"

#include <algorithm>
#include <atomic>
#include <bit>

#include "catch.h"
#include "random.h"
#include "rt/files/scene_reader.h"
#include "rt/render.h"

namespace {

using namespace rt;

/// Passes of a picture whose samples take so long each, and whose error falls as samples^-rate.
SoFar run(const Goals& limits, Real per_sample, Real rate, int& passes, Random* noise = nullptr) {
    SoFar s;
    for (passes = 0;; ++passes) {
        const int count = next_pass(limits, s);
        if (count == 0) return s;
        CHECK(std::has_single_bit(unsigned(count)));
        const Real each = per_sample * (noise ? noise->between(0.9, 1.1) : 1);
        s.samples += std::uint64_t(count), s.seconds += count * each, s.per_sample = each;
        s.rmse = std::pow(Real(s.samples), -rate);
    }
}

Scene scene_of_file(const char* file) {
    Scene scene = read_scene(file);
    scene.camera.size = {24, 16};
    return scene;
}

}  // namespace

TEST_CASE("passes fill the time within ten per cent, however long a sample takes", "[schedule]") {
    Random random(1);
    for (int k = 0; k < 1000; ++k) {
        const Real limit = random.scale(0.01, 1e4), per_sample = limit * random.scale(1e-5, 0.05);
        int passes = 0;
        const SoFar s = run({limit, 0}, per_sample, 0.5, passes, &random);
        INFO("limit " << limit << " s, a sample " << per_sample << " s: " << s.seconds << " s in " << passes
                      << " passes");
        CHECK((s.seconds > 0.9 * limit && s.seconds < 1.03 * limit));
        CHECK(passes < 60);
    }
}

TEST_CASE("where one sample of each pixel takes long, none is begun that does not fit", "[schedule]") {
    int passes = 0;
    CHECK(run({1, 0}, 0.3, 0.5, passes).samples == 3);
    CHECK(run({1, 0}, 0.6, 0.5, passes).samples == 1);
    CHECK(run({1, 0}, 5, 0.5, passes).samples == 1);
}

TEST_CASE("an error is reached, with an eighth more samples than it takes, or three times as many where it falls fast",
          "[schedule]") {
    Random random(2);
    for (int k = 0; k < 300; ++k) {
        const Real error = random.scale(1e-4, 0.2), rate = k % 2 ? 0.5 : 1;
        int passes = 0;
        const SoFar s = run({inf, error}, 1, rate, passes);
        const Real wanted = std::max<Real>(16, std::pow(error, -1 / rate));
        INFO("error " << error << ": " << s.samples << " samples, wanted " << wanted << ", " << passes << " passes");
        CHECK(s.rmse <= error);
        CHECK(Real(s.samples) <= (rate == 0.5 ? 1.15 : 3) * wanted + 1);
    }
}

TEST_CASE("the first limit that is reached ends the rendering", "[schedule]") {
    int passes = 0;
    const SoFar by_error = run({1000, 0.05}, 0.01, 0.5, passes), by_time = run({10, 1e-6}, 0.01, 0.5, passes);
    CHECK((by_error.rmse <= 0.05 && by_error.seconds < 10));
    CHECK((by_time.seconds <= 10 && by_time.seconds > 9));
}

TEST_CASE("passes that go on make the picture that one pass with all samples makes", "[schedule]") {
    Scene scene = scene_of_file("scenes/gallery/cornell.toml");
    const Rendering passes = render(scene, {.seed = 3, .sampler = Sampler::orthogonal, .target_error = 0.05});
    const RenderSettings once{.samples = int(passes.samples), .seed = 3, .sampler = Sampler::sobol};
    const Rendering at_once = render(scene, once);
    REQUIRE(passes.samples >= 16);
    for (std::size_t k = 0; k < at_once.image.pixels.size(); ++k) {
        const Color a = passes.image.pixels[k], b = at_once.image.pixels[k];
        INFO("pixel " << k << " of " << passes.samples << " samples: " << a.x << " in passes, " << b.x << " at once");
        CHECK(length(a - b) <= 1e-12 * length(b));
    }
    CHECK(std::abs(passes.rmse / at_once.rmse - 1) < 1e-9);
}

TEST_CASE("with any sampler, the error that is estimated is the error, and the mean is that of many samples",
          "[schedule]") {
    const Scene scene = scene_of_file("scenes/gallery/cornell.toml");
    const Image truth = render(scene, {.samples = 1 << 12, .sampler = Sampler::sobol, .estimate_error = false}).image;
    for (const Sampler sampler : {Sampler::random, Sampler::stratified, Sampler::sobol, Sampler::orthogonal}) {
        Sum squares, estimates, bias;
        constexpr int pictures = 20;
        constexpr Real target = 0.04;
        for (int k = 0; k < pictures; ++k) {
            const Rendering r =
                render(scene, {.seed = std::uint64_t(100 + k), .sampler = sampler, .target_error = target});
            CHECK(r.rmse <= target);
            estimates.add(sqr(r.rmse) / pictures);
            for (std::size_t p = 0; p < truth.pixels.size(); ++p) {
                const Color d = r.image.pixels[p] - truth.pixels[p];
                squares.add(dot(d, d) / 3 / Real(truth.pixels.size()) / pictures);
                bias.add((d.x + d.y + d.z) / 3 / Real(truth.pixels.size()) / pictures);
            }
        }
        const Real error = std::sqrt(squares.value()), estimate = std::sqrt(estimates.value());
        INFO(sampler_names[std::size_t(sampler)] << ": error " << error << ", estimated " << estimate << ", bias "
                                                 << bias.value());
        CHECK((error > 0.85 * estimate && error < 1.25 * estimate));
        CHECK(std::abs(bias.value()) < 4 * target / std::sqrt(Real(truth.pixels.size()) * pictures));
    }
}

TEST_CASE("what is stopped in the middle leaves no uneven picture", "[schedule]") {
    const Scene scene = scene_of_file("scenes/gallery/cornell.toml");
    RenderSettings settings{.threads = 1, .target_error = 1e-9};
    // Asked before each chunk: the end falls into the middle of a pass.
    for (const int end : {3, 20, 150, 151, 152}) {
        int asked = 0;
        settings.stop = [&] { return ++asked > end; };
        const Rendering stopped = render(scene, settings);
        INFO("stopped after " << end << " chunks: " << stopped.samples << " samples");
        REQUIRE(stopped.done == 1);
        const RenderSettings once{.samples = std::max(2, int(stopped.samples)), .sampler = Sampler::sobol};
        if (stopped.samples < 2) continue;
        const Image whole = render(scene, once).image;
        for (std::size_t k = 0; k < whole.pixels.size(); ++k)
            CHECK(length(stopped.image.pixels[k] - whole.pixels[k]) <= 1e-12 * length(whole.pixels[k]));
    }
}

TEST_CASE("of a first pass that is not over in time, there is what was rendered, and how much", "[schedule]") {
    Scene scene = read_scene("scenes/gallery/cornell.toml");
    scene.camera.size = {2000, 2000};
    scene.background = Color(1);
    const Rendering r = render(scene, {.time_limit = 0.2});
    INFO("done " << r.done << " after " << r.wall_seconds << " s");
    CHECK((r.done > 0 && r.done < 1));
    CHECK(std::isnan(r.rmse));
    const auto lit = std::count_if(r.image.pixels.begin(), r.image.pixels.end(), [](Color c) { return c != Color(0); });
    CHECK((lit > 0 && Real(lit) < (r.done + 0.05) * Real(r.image.pixels.size())));
}

TEST_CASE("who looks on sees each picture whole, one at a time, and at last the one that comes out", "[schedule]") {
    const Scene scene = scene_of_file("scenes/gallery/cornell.toml");
    RenderSettings settings{.time_limit = 1};
    std::atomic<int> at_once = 0;
    int looks = 0;
    Real before = 0;
    settings.show = [&](const Image& image) {
        CHECK(++at_once == 1);
        CHECK((image.width == 24 && image.height == 16));
        ++looks;
        --at_once;
    };
    settings.progress = [&](Real done, Real) {
        CHECK((done >= before && done <= 1));
        before = done;
    };
    render(scene, settings);
    INFO(looks << " looks");
    CHECK((looks >= 3 && looks <= 11));
}
