#include "rt/plan.h"

#include <filesystem>

#include "build/files.h"
#include "catch.h"
#include "rt/render.h"
#include "rt/files/scene_reader.h"

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

TEST_CASE("a feature that is there in name only changes no bit and sends no ray") {
    const std::string text = R"(
[render]
bounces = 1
[camera]
eye = [0, 1, 5]
target = [0, 0.5, 0]
vfov = 40
[materials.grey]
albedo = [0.5, 0.4, 0.3]
[materials.mirror]
reflectance = 0.9
[materials.lamp]
emission = [5, 5, 5]
[[light]]
type = "point"
position = [0, 3, 2]
intensity = [9, 9, 9]
[[shape]]
type = "quad"
center = [0, 0, 0]
u = [9, 0, 0]
v = [0, 0, -9]
material = "grey"
[[shape]]
type = "sphere"
center = [0, 1, 0]
radius = 0.7
material = "mirror"
[[shape]]
type = "quad"
center = [0, 4, 0]
u = [1, 0, 0]
v = [0, 0, 1]
material = "lamp"
)";
    const auto drawn = [](const std::string& t) { return small_picture(parse_scene(t, "scene.toml")); };
    const Rendering plain = drawn(text);
    CHECK(plain.rays[std::size_t(RayKind::bounce)] > 0);

    const std::string camera = "vfov = 40\n", sphere = "radius = 0.7\n", grey = "albedo = [0.5, 0.4, 0.3]\n";
    CHECK(same(plain, drawn(changed(text, camera, camera + "lens_radius = 0\nfocus = 3\n"))));
    CHECK(same(plain, drawn(changed(text, sphere, sphere + "velocity = [0, 0, 0]\n") + "[shutter]\nopen = 0\nclose = 1\n")));
    CHECK(same(plain, drawn(changed(text, sphere, sphere + "velocity = [3, 2, 1]\n") + "[shutter]\nopen = 0\nclose = 0\n")));
    CHECK(same(plain, drawn(changed(text, grey, grey + "emission = [0, 0, 0]\n"))));
    CHECK(same(plain, drawn(changed(text, grey, grey + "reflectance = 0\ntransmittance = 0\nexponent = 20\n"))));
    CHECK(same(plain, drawn("environment = 0\nbackground = 0\nambient = 0\n" + text)));
    // a material that no shape has
    CHECK(same(plain, drawn(changed(text, "[materials.mirror]",
                                    "[materials.unused]\nalbedo = 0.1\nreflectance = 0.2\ntransmittance = 0.5\nexponent = 5\n"
                                    "emission = [1, 1, 1]\n[materials.mirror]"))));
    // and what is really there does
    CHECK(!same(plain, drawn(changed(text, camera, camera + "lens_radius = 0.1\nfocus = 3\n"))));
}
