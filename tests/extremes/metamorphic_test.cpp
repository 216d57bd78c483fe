/// A picture against itself: extremes.md 1 to 9, 58, 61.

#include <algorithm>

#include "extremes/transform.h"
#include "rt/fragments.h"
#include "rt/stages/stages.h"

using namespace rt;

namespace {

const std::vector<std::string> ten_scenes = {"whitted",     "penumbra",   "sphere_light",   "depth_of_field",
                                             "motion_blur", "glossy",     "color_bleeding", "scattering",
                                             "mesh",        "many_shapes"};
const std::vector<std::string> whitted_scenes = {"whitted", "phong",  "refraction", "fresnel",
                                                 "mirror",  "shadow", "mesh"};

/// Turns a scene by a map of vectors that keeps lengths: a mirror image, say, which has the corners run the other way
/// round. The camera's axes go with it, so the picture stays as it is.
template <class Map>
Scene turned(Scene scene, Map map) {
    const bool mirrored = dot(map(vec3(1, 0, 0)), cross(map(vec3(0, 1, 0)), map(vec3(0, 0, 1)))) < 0;
    transform(scene, map, map, [](Real x) { return x; });
    Camera& c = scene.camera;
    c.right = map(c.right), c.up = map(c.up), c.back = map(c.back);
    for (PointLight& light : scene.lights)
        if (light.directional) light.position = map(light.position);
    for (Shape& shape : scene.shapes)
        if (auto* d = std::get_if<Disc>(&shape.geometry)) d->normal = map(d->normal);
    if (mirrored) {
        for (Shape& shape : scene.shapes) {
            if (auto* t = std::get_if<Triangle>(&shape.geometry)) std::swap(t->b, t->c);
            if (auto* q = std::get_if<Quad>(&shape.geometry)) std::swap(q->u, q->v);
        }
        for (Mesh& mesh : scene.meshes)
            for (auto& t : mesh.triangles) std::swap(t.y, t.z);
    }
    for (Mesh& mesh : scene.meshes)
        for (vec3& n : mesh.normals) n = map(n);
    return scene;
}

Image rendered(const Scene& scene, std::optional<Crop> crop = {}, int threads = 1) {
    return render(scene, {.samples = scene.samples, .threads = threads, .sampler = scene.sampler, .crop = crop}).image;
}

}  // namespace

TEST_CASE("1 ten scenes, scaled by 2^k, k = -40 ... 40: the same picture, bit by bit", "[extremes]") {
    for (const std::string& name : ten_scenes) {
        const Scene scene = small_scene(name);
        const Image image = picture(scene);
        int changed = 0;
        for (int k = -40; k <= 40; ++k) changed += pixels_apart(picture(scaled(scene, power_of_two(k))), image) > 0;
        figure(1, name + ": pictures that change with the scale, of 81", changed, 0);
    }
}

TEST_CASE("2 scaled by 1e-6, 1e6, 1e9: relative 1e-9", "[extremes]") {
    Greatest share;
    std::int64_t pixels = 0, apart = 0;
    for (const std::string& name : ten_scenes) {
        const Scene scene = small_scene(name);
        const Image image = picture(scene);
        for (const Real factor : {1e-6, 1e6, 1e9}) {
            const Image other = picture(scaled(scene, factor));
            for (std::size_t i = 0; i < image.pixels.size(); ++i) {
                ++pixels;
                apart += largest(other.pixels[i] - image.pixels[i]) > 1e-9 * largest(image.pixels[i]);
            }
        }
    }
    figure(2, "pixels off by more than 1e-9, share of " + std::to_string(pixels), Real(apart) / Real(pixels), 1e-3);
}

TEST_CASE("3 moved by 2^20, vertices on a grid of 2^-20: primary distances bit by bit", "[extremes]") {
    std::int64_t different = 0, rays = 0;
    for (const std::string name : {"whitted", "mesh", "many_shapes", "hit_disc", "hit_quad", "hit_triangle"}) {
        Scene scene = small_scene(name);
        const auto to_grid = [](vec3 p) { return glm::round(p * 0x1p20) * 0x1p-20; };
        const auto same = [](auto x) { return x; };
        transform(scene, to_grid, same, same);
        Scene moved_scene = scene;
        transform(
            moved_scene, [](vec3 p) { return p + vec3(0x1p20, -0x1p20, 0x1p20); }, same, same);
        const World here = make_world(scene), there = make_world(moved_scene);
        for (int y = 0; y < 64; ++y) {
            Batch a{}, b{};
            a.count = b.count = lanes;
            Camera camera = scene.camera, moved_camera = moved_scene.camera;
            camera.size = moved_camera.size = {64, 64};
            for (int x = 0; x < 64; ++x) {
                a.set_ray(x, camera_ray(camera, {x + 0.5, y + 0.5}));
                b.set_ray(x, camera_ray(moved_camera, {x + 0.5, y + 0.5}));
            }
            nearest_stage(here, a);
            nearest_stage(there, b);
            for (int x = 0; x < 64; ++x) different += a.far[x] != b.far[x] || a.shape[x] != b.shape[x], ++rays;
        }
    }
    figure(3, "primary rays that meet something else 2^20 away, of " + std::to_string(rays), double(different), 0);
}

TEST_CASE("4 a mirror image of a Whitted scene: bit by bit", "[extremes]") {
    std::int64_t apart = 0;
    for (const std::string& name : whitted_scenes) {
        Scene scene = small_scene(name);
        // Interpolated normals are a sum of three, in the order of the corners, which a mirror image turns round.
        for (Mesh& mesh : scene.meshes) mesh.normals.clear();
        const auto here =
            pixels_apart(picture(turned(scene, [](vec3 v) { return vec3(-v.x, v.y, v.z); })), picture(scene));
        INFO(name << ": " << here);
        CHECK(here == 0);
        apart += here;
    }
    figure(4, "pixels of mirrored scenes that differ", double(apart), 0);
}

TEST_CASE("5 axes permuted: relative 1e-12 away from edges", "[extremes]") {
    std::int64_t apart = 0, pixels = 0;
    for (const std::string& name : whitted_scenes) {
        const Scene scene = small_scene(name);
        const Image image = picture(scene);
        for (const bool swap : {false, true}) {
            const auto permuted = [swap](vec3 v) { return swap ? vec3(v.y, v.x, v.z) : vec3(v.y, v.z, v.x); };
            const Image other = picture(turned(scene, permuted));
            for (std::size_t i = 0; i < image.pixels.size(); ++i)
                apart += largest(other.pixels[i] - image.pixels[i]) > 1e-12 * largest(image.pixels[i]), ++pixels;
        }
    }
    figure(5, "pixels off by more than 1e-12, share of " + std::to_string(pixels), Real(apart) / Real(pixels), 1e-2);
}

TEST_CASE("6 emission times 2^60 and 2^-60: the picture times as much, bit by bit", "[extremes]") {
    std::int64_t apart = 0;
    for (const std::string& name : ten_scenes) {
        const Scene scene = small_scene(name);
        for (const int k : {-60, 60}) {
            Image image = picture(scene);
            for (Color& c : image.pixels) c *= power_of_two(k);
            apart += pixels_apart(picture(brighter(scene, power_of_two(k))), image);
        }
    }
    figure(6, "pixels that are not 2^+-60 times as bright", double(apart), 0);
}

TEST_CASE("7 lights A, B, and both: the sum within 4u", "[extremes]") {
    Greatest worst, worst_of_paths;
    for (const std::string& name : whitted_scenes) {
        Scene both = small_scene(name);
        both.samples = 1;
        both.ambient = both.environment = both.background = Color(0);
        for (Material& m : both.materials) m.emission = Color(0);
        both.lights = {{both.camera.eye + vec3(3, 2, 1), Color(20), false},
                       {both.camera.eye + vec3(-1, 5, 0), Color(30), false}};
        Scene a = both, b = both;
        a.lights.pop_back();
        b.lights.erase(b.lights.begin());
        const Image of_a = picture(a), of_b = picture(b), of_both = picture(both);
        for (std::size_t i = 0; i < of_a.pixels.size(); ++i) {
            const Color sum = of_a.pixels[i] + of_b.pixels[i];
            if (largest(sum) == 0) continue;
            (make_plan(both).specular ? worst_of_paths : worst)
                .see(largest(of_both.pixels[i] - sum) / (roundoff * largest(sum)));
        }
    }
    figure(7, "sum of two lights' pictures against both, in u", worst.value, 4);
    figure(7, "likewise where mirrors and glass add up to 16 surfaces", worst_of_paths.value, 8);
}

TEST_CASE("8 any number of threads, any part of the picture: the same bits", "[extremes]") {
    std::int64_t apart = 0;
    for (const std::string& name : ten_scenes) {
        const Scene scene = small_scene(name);
        const Image image = rendered(scene);
        for (const int threads : {2, 3, 7, 16}) apart += pixels_apart(rendered(scene, {}, threads), image);
        for (const Crop crop : {Crop{5, 3, 1, 1}, Crop{0, 7, 32, 2}, Crop{3, 2, 11, 13}}) {
            const Image part = rendered(scene, crop, 3);
            for (int y = 0; y < crop.height; ++y)
                for (int x = 0; x < crop.width; ++x) apart += part.at(x, y) != image.at(crop.x + x, crop.y + y);
        }
    }
    figure(8, "pixels that depend on threads or on the part that is drawn", double(apart), 0);
}

TEST_CASE("9 objects in another order: bit by bit", "[extremes]") {
    // With two emitters the order decides which random numbers each gets.
    std::int64_t apart = 0;
    Random random(9);
    for (const std::string name : {"whitted", "sphere_light", "depth_of_field", "glossy", "many_shapes", "mesh"}) {
        const Scene scene = small_scene(name);
        const Image image = picture(scene);
        for (int k = 0; k < 5; ++k) {
            Scene other = scene;
            std::shuffle(other.shapes.begin(), other.shapes.end(), random.engine);
            for (Mesh& mesh : other.meshes) std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random.engine);
            apart += pixels_apart(picture(other), image);
        }
    }
    figure(9, "pixels that depend on the order of the objects", double(apart), 0);
}

TEST_CASE("58 61 aperture 0, a closed shutter, things at rest: bitwise as without", "[extremes]") {
    Scene lens = small_scene("depth_of_field");
    lens.camera.lens_radius = 0;
    Scene pinhole = lens;
    pinhole.camera.focus = inf;
    figure(58, "pixels that an aperture of 0 changes", double(pixels_apart(picture(lens), picture(pinhole))), 0);

    const Scene moving = small_scene("motion_blur");
    Scene still = moving, instant = moving;
    for (Shape& shape : still.shapes) shape.velocity = vec3(0);
    instant.shutter.close = instant.shutter.open = 0;
    Scene closed = still;
    closed.shutter = {0, 0};
    figure(61, "pixels that a closed shutter changes", double(pixels_apart(picture(instant), picture(closed))), 0);
    figure(61, "pixels that an open shutter changes where nothing moves",
           double(pixels_apart(picture(still), picture(closed))), 0);
}
