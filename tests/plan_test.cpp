#include "rt/plan.h"

#include <fmt/format.h>

#include <filesystem>
#include <set>

#include "catch.h"
#include "files/files.h"
#include "rt/calls.h"
#include "rt/files/scene_reader.h"
#include "rt/render.h"
#include "rt/trace.h"
#include "scenes.h"

using namespace rt;

namespace {

/// What the scene's shapes are made of, read without the plan.
struct Content {
    bool mirror = false, glass = false, lobe = false, bounce = false, medium = false, light = false;
};

Content content_of(const Scene& scene) {
    Content has;
    std::vector<int> used;
    for (const Shape& shape : scene.shapes) used.push_back(shape.material);
    for (const Mesh& mesh : scene.meshes) used.push_back(mesh.material);
    has.light = !scene.lights.empty() || scene.environment != Color(0);
    for (const int i : used) {
        const Material& m = scene.materials[std::size_t(i)];
        has.mirror |= m.reflectance != Color(0) && m.exponent == inf;
        has.glass |= m.transmittance != Color(0) && m.exponent == inf;
        has.lobe |= (m.reflectance != Color(0) || m.transmittance != Color(0)) && m.exponent < inf;
        has.bounce |= m.albedo != Color(0) && scene.bounces > 0;
        has.medium |= m.transmittance != Color(0) && m.medium.extinction > 0;
        has.light |= m.emission != Color(0) && m.sampled;
    }
    return has;
}

Rendering small_picture(Scene scene) {
    scene.camera.size = {16, 16};
    return render(scene, {.samples = 4, .sampler = scene.sampler, .estimate_error = false});
}

/// The text with other words in the place of some that must be there.
std::string changed(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    REQUIRE(at != text.npos);
    return text.replace(at, from.size(), to);
}

/// The fragments that a plan's stages call.
std::set<std::string> called(const RenderPlan& plan) {
    std::set<std::string> names;
    for (const Calls& calls : calls_of(plan)) names.insert(calls.fragments.begin(), calls.fragments.end());
    return names;
}

bool same(const Rendering& a, const Rendering& b) { return a.image.pixels == b.image.pixels && a.rays == b.rays; }

}  // namespace

TEST_CASE("what a scene does not have sends no ray, in every scene") {
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator("scenes")) {
        if (entry.path().extension() != ".toml") continue;
        const Scene scene = read_scene(entry.path().string());
        const Content has = content_of(scene);
        const RayCounts rays = small_picture(scene).rays;
        const auto count = [&](RayKind kind) { return rays[std::size_t(kind)]; };
        INFO(entry.path().string());
        CHECK(count(RayKind::camera) == 4 * 16 * 16);
        if (!has.mirror) CHECK(count(RayKind::mirror) == 0);
        if (!has.glass) CHECK(count(RayKind::glass) == 0);
        if (!has.lobe) CHECK(count(RayKind::lobe) == 0);
        if (!has.bounce) CHECK(count(RayKind::bounce) == 0);
        if (!has.medium) CHECK(count(RayKind::medium) == 0);
        if (!has.light) CHECK(count(RayKind::shadow) == 0);
        ++scenes;
    }
    CHECK(scenes >= 40);
}

TEST_CASE("each dimension of each wave has a number of its own, and a new one changes nobody else's") {
    const RenderPlan plan = make_plan(read_scene("scenes/many_lights.toml"));
    std::set<std::uint64_t> numbers;
    for (int camera = 0; camera < camera_dimensions; ++camera) numbers.insert(std::uint64_t(camera));
    for (int wave = 0; wave < 100; ++wave)
        for (int dimension = -most_new_dimensions; dimension < plan.wave_dimensions; ++dimension) {
            CHECK(numbers.insert(plan.number(wave, dimension)).second);
            CHECK(plan.place(dimension) < plan.pairs.size());
        }
    // as they have been since pictures have hashes
    CHECK(plan.number(0, choice_dimension) == 3);
    CHECK(plan.number(2, light_dimension + 1) == std::uint64_t(3 + 2 * plan.wave_dimensions + 6));
}

TEST_CASE("a feature that is there in name only changes no bit and sends no ray") {
    const std::string text = scene_table("[render]", {{"bounces", 1}}) +
                             camera({0, 1, 5}, {0, 0.5, 0}, {{"vfov", 40}}) +
                             material("grey", {{"albedo", vec3(0.5, 0.4, 0.3)}}) +
                             material("mirror", {{"reflectance", 0.9}}) + material("lamp", {{"emission", 5}}) +
                             point_light({0, 3, 2}, 9) + quad("grey", {0, 0, 0}, {9, 0, 0}, {0, 0, -9}) +
                             sphere("mirror", {0, 1, 0}, 0.7) + quad("lamp", {0, 4, 0}, {1, 0, 0}, {0, 0, 1});
    const auto drawn = [](const std::string& t) { return small_picture(parse_scene(t, "scene.toml")); };
    const Rendering plain = drawn(text);
    CHECK(plain.rays[std::size_t(RayKind::bounce)] > 0);

    const std::string vfov = "vfov = 40\n", radius = "radius = 0.7\n", grey = "albedo = [0.5, 0.4, 0.3]\n";
    CHECK(same(plain, drawn(changed(text, vfov, vfov + "lens_radius = 0\nfocus = 3\n"))));
    CHECK(same(plain,
               drawn(changed(text, radius, radius + "velocity = [0, 0, 0]\n") + "[shutter]\nopen = 0\nclose = 1\n")));
    CHECK(same(plain,
               drawn(changed(text, radius, radius + "velocity = [3, 2, 1]\n") + "[shutter]\nopen = 0\nclose = 0\n")));
    CHECK(same(plain, drawn(changed(text, grey, grey + "emission = [0, 0, 0]\n"))));
    CHECK(same(plain, drawn(changed(text, grey, grey + "reflectance = 0\ntransmittance = 0\nexponent = 20\n"))));
    CHECK(same(plain, drawn("environment = 0\nbackground = 0\nambient = 0\n" + text)));
    // a material that no shape has
    CHECK(same(plain,
               drawn(changed(text, "[materials.mirror]",
                             "[materials.unused]\nalbedo = 0.1\nreflectance = 0.2\ntransmittance = 0.5\nexponent = 5\n"
                             "emission = [1, 1, 1]\n[materials.mirror]"))));
    // and what is really there does
    CHECK(!same(plain, drawn(changed(text, vfov, vfov + "lens_radius = 0.1\nfocus = 3\n"))));
}

TEST_CASE("there is an integral over the pixel where it has more than one sample, in one pass or in many") {
    const Scene scene = read_scene("scenes/depth_of_field.toml");
    const auto plan = [&](int samples, bool passes) { return make_plan(scene, {samples, passes, scene.sampler}); };
    for (const bool passes : {false, true})
        for (const int samples : {1, 2, 16}) {
            CAPTURE(samples, passes);
            const bool several = samples > 1 || passes;
            CHECK(plan(samples, passes).pixel == several);
            CHECK(called(plan(samples, passes)).contains("film_sample") == several);
            CHECK(called(plan(samples, passes)).contains("pixel_mean") == several);
            // without it, the lens has the first of the pattern's dimensions
            CHECK(plan(samples, passes).pairs[pixel_dimension] == (several ? 0 : -1));
            CHECK(plan(samples, passes).pairs[lens_dimension] == (several ? 1 : 0));
        }
    CHECK(sampling_of(RenderSettings{.samples = 1}).passes == false);
    CHECK(sampling_of(RenderSettings{.samples = 1, .time_limit = 1}).passes);
    CHECK(sampling_of(RenderSettings{.samples = 1, .target_error = 0.1}).passes);
    CHECK(make_plan(scene, sampling_of(RenderSettings{.samples = 1, .one_of_many = true})).pixel);
}

TEST_CASE("one sample goes through the pixel's centre: nothing is random, unless it is one of many passes") {
    Scene scene = read_scene("scenes/whitted.toml");
    scene.camera.size = {32, 24};
    const auto drawn = [&](std::uint64_t seed, Sampler sampler, Real error) {
        return render(scene, {.samples = 1, .seed = seed, .sampler = sampler, .target_error = error}).image.pixels;
    };
    const auto picture = drawn(1, Sampler::uniform, 0);
    for (const Sampler sampler : {Sampler::random, Sampler::stratified, Sampler::sobol, Sampler::orthogonal}) {
        CAPTURE(sampler_names[std::size_t(sampler)]);
        CHECK(drawn(1, sampler, 0) == picture);
        CHECK(drawn(2, sampler, 0) == picture);
        CHECK(drawn(1, sampler, 1e9) != picture);
    }
    // the ray through the centre, in a picture whose pixels are a third as large
    scene.camera.size = {96, 72};
    const auto finer = drawn(1, Sampler::random, 0);
    CHECK(finer[std::size_t(3 * 12 + 1) * 96 + 3 * 16 + 1] == picture[12 * 32 + 16]);
}

TEST_CASE("what is told of a pixel is what was drawn") {
    Scene scene = read_scene("scenes/whitted.toml");
    scene.camera.size = {32, 24};
    const auto told = [&](const RenderSettings& settings) { return trace_pixel(scene, settings, 20, 11); };
    for (const int samples : {1, 4}) {
        const RenderSettings settings{.samples = samples, .seed = 3};
        const Color c = render(scene, settings).image.at(20, 11);
        CHECK(trace_paths(scene, settings, 20, 11).mean == c);
        CHECK(told(settings).ends_with(fmt::format(" ({:.6g}, {:.6g}, {:.6g})\n", c.x, c.y, c.z)));
    }
    CHECK(told({.samples = 1, .seed = 3}) == told({.samples = 1, .seed = 4}));
    CHECK(told({.samples = 1, .seed = 3}) != told({.samples = 1, .seed = 3, .target_error = 1}));
}

TEST_CASE("emission_counts is asked where diffuse rays go and something shines that shadow rays may have found") {
    struct Case {
        std::string scene;
        bool asked;
    };
    const std::string floor = camera({0, 1, 5}, {0, 0, 0}) + material("floor", {{"albedo", 0.5}}) +
                              material("mirror", {{"reflectance", 0.5}}) + material("lamp", {{"emission", 5}}) +
                              sphere("floor", {0, 0, 0}, 1),
                      lamp = sphere("lamp", {0, 3, 0}, 1), bounces = scene_table("[render]", {{"bounces", 2}}),
                      mirror = changed(floor, "\"floor\"\n", "\"mirror\"\n");
    const Case cases[] = {
        {bounces + floor + lamp, true},
        {"environment = 1\n" + bounces + floor, false},  // no shadow ray looks for what bounces finds
        {"environment = 1\n" + bounces + changed(floor, "albedo = 0.5", "albedo = 0.5\nreflectance = 0.1"), true},
        {bounces + changed(floor, "emission = 5", "emission = 5\nsampled = false") + lamp, true},
        {"background = 1\n" + bounces + floor, false},
        {bounces + floor, false},
        {floor + lamp, false},
        {"environment = 1\n" + floor + lamp, false},
        {bounces + mirror + lamp, false},
        {"environment = 1\n" + bounces + mirror, false}};
    for (const Case& c : cases) {
        CAPTURE(c.scene);
        const RenderPlan plan = make_plan(parse_scene(c.scene, "scene.toml"));
        CHECK(plan.counts_twice == c.asked);
        CHECK(called(plan).contains("emission_counts") == c.asked);
    }
}

TEST_CASE("the plan names the fragments that its stages call") {
    const auto names = [](const std::string& scene, const Sampling& sampling) {
        return called(make_plan(read_scene("scenes/" + scene + ".toml"), sampling));
    };
    using Names = std::set<std::string>;
    Names whitted{
        "camera_ray",       "hit_sphere",          "hit_quad",           "point_irradiance", "phong", "shadow_ray",
        "mirror_direction", "refracted_direction", "fresnel_dielectric", "whitted"};
    CHECK(names("whitted", {1, false, Sampler::stratified}) == whitted);
    whitted.insert({"film_sample", "pixel_mean"});
    CHECK(names("whitted", {4, false, Sampler::stratified}) == whitted);
    CHECK(names("whitted", {1, true, Sampler::random}) == whitted);

    Names penumbra{"camera_ray", "hit_quad", "light_sample", "direct_light", "shadow_ray", "film_sample", "pixel_mean"};
    CHECK(names("penumbra", {4, false, Sampler::orthogonal}) == penumbra);
    penumbra.insert("stratified_2d");
    CHECK(names("penumbra", {4, false, Sampler::stratified}) == penumbra);
    CHECK(names("penumbra", {4, false, Sampler::uniform}) == penumbra);
    CHECK(names("environment", {1, false, Sampler::sobol}) ==
          Names{"camera_ray", "hit_sphere", "hit_quad", "cosine_hemisphere", "shadow_ray"});
}

TEST_CASE("lamps are sampled as the scene says, and where it says nothing as saves time") {
    const std::string floor = material("floor", {{"albedo", 0.5}}) +
                              material("lobe", {{"reflectance", 0.9}, {"exponent", 50}}) +
                              material("lamp", {{"emission", 5}}) + quad("floor", {0, 0, 0}, {9, 0, 0}, {0, 0, -9});
    const std::string view = camera({0, 2, 6}, {0, 0.5, 0}) + floor,
                      from_below = camera({0, 0.5, 6}, {0, 1.5, 0}) + floor,
                      down = camera({0, 4, 4}, {0, 0, 0}) + floor;
    const auto lamp = [](Real x, Real y, Real half) { return quad("lamp", {x, y, 0}, {half, 0, 0}, {0, 0, half}); };
    const std::string ball = sphere("lobe", {0, 0.6, 1}, 0.6), far = lamp(0, 5, 0.3), near = lamp(0, 0.4, 1);
    std::string row;
    for (int k = 0; k < 40; ++k) row += lamp(0.4 * (k - 20), 2, 0.1);

    const auto plan = [&](const std::string& text) { return make_plan(parse_scene(text, "scene.toml")); };
    CHECK(!plan(view + far).solid_angle);
    CHECK(plan(view + near).solid_angle);
    CHECK(!plan(view + far + near).one_lamp);
    CHECK(!plan(view + row).one_lamp);
    // Of four lamps, three shine upwards: one that is chosen is rarely the right one.
    std::string ceiling;
    for (int k = 0; k < 256; ++k)
        ceiling += quad("lamp", {0.4 * (k % 16 - 8), 6 + 0.01 * k, 0}, {0.05, 0, 0}, {0, 0, k % 4 == 0 ? 0.05 : -0.05});
    CHECK(!plan(down + ceiling).one_lamp);
    CHECK(plan(down + ceiling + far).one_lamp);  // more than may be taken at each point
    CHECK(!plan("[render]\none_lamp = false\n" + down + ceiling + far).one_lamp);
    CHECK(plan(from_below + row).one_lamp);  // the edges of the lamps are seen, and noisier than any choice
    CHECK(!plan(view + far).weigh);
    CHECK(plan(view + ball + far).weigh);

    const std::string all = "[render]\nsolid_angle = true\none_lamp = true\nmultiple_importance = true\n",
                      none = "[render]\nsolid_angle = false\none_lamp = false\nmultiple_importance = false\n";
    const RenderPlan on = plan(all + view + ball + far + near), off = plan(none + view + ball + near + row);
    CHECK((on.solid_angle && on.one_lamp && on.weigh));
    CHECK((!off.solid_angle && !off.one_lamp && !off.weigh));

    const Scene scene = parse_scene(view + ball + near, "scene.toml");
    const std::string text = describe(make_plan(scene), scene);
    for (const char* reason :
         {"of quads: otherwise 10 times the variance", "no two lamps", "lobes alone find lamps: otherwise"}) {
        CAPTURE(reason, text);
        CHECK(text.find(reason) != text.npos);
    }
}
