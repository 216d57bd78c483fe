/// Paths of any length: extremes.md 36, 52 to 55, 57.

#include <algorithm>

#include "extremes/transform.h"
#include "rt/fragments.h"
#include "rt/path.h"

using namespace rt;

namespace {

Quad wall(vec3 center, vec3 u, vec3 v) { return {center, u, v}; }

/// A closed room of six quads that face inwards, and a camera in its middle.
Scene room(const Material& material) {
    Scene scene;
    scene.materials = {material};
    const vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    for (const auto& q : {wall(-x, y, z), wall(x, z, y), wall(-y, z, x), wall(y, x, z), wall(-z, x, y), wall(z, y, x)})
        scene.shapes.push_back({q, 0, vec3(0)});
    scene.camera.eye = {0.1, 0.2, 0.3};
    scene.camera.size = {2, 2};
    scene.samples = 1;
    return scene;
}

/// The mean over channels and pixels, and the largest difference from it.
struct Flat {
    Real mean, off;
};
Flat flatness(const Image& image) {
    Sum sum;
    for (const Color& c : image.pixels) sum.add(c.x), sum.add(c.y), sum.add(c.z);
    const Real mean = sum.value() / (3 * Real(image.pixels.size()));
    Greatest off;
    for (const Color& c : image.pixels) off.see(largest(c - Color(mean)));
    return {mean, off.value};
}

/// E (1 - a^(n))/(1 - a), the sum of n terms, exactly enough.
Real geometric(Real e, Real a, std::int64_t n) {
    return double(-e * std::expm1((long double)(n)*std::log((long double)(a))) / (1 - (long double)(a)));
}

}  // namespace

TEST_CASE("36 a white object within an emitter: L = Le within 1e-12", "[extremes]") {
    // By bouncing into the walls, and by sampling an environment.
    Material lamp, white;
    lamp.emission = Color(7), lamp.sampled = false;
    white.albedo = Color(1);
    Scene scene = room(lamp);
    scene.materials.push_back(white);
    scene.shapes.push_back({Sphere{{0.1, 0.2, -0.3}, 0.4}, 1, vec3(0)});
    scene.bounces = 1;
    scene.samples = 16;
    const Flat walls = flatness(picture(scene));
    figure(36, "white ball in a shining room, relative", std::max(std::abs(walls.mean - 7), walls.off) / 7, 1e-12);

    scene.shapes.erase(scene.shapes.begin(), scene.shapes.begin() + 6);
    scene.environment = Color(7);
    const Flat sky = flatness(picture(scene));
    figure(36, "white ball under a shining sky, relative", std::max(std::abs(sky.mean - 7), sky.off) / 7, 1e-12);
}

TEST_CASE("52 a glass ball in a furnace: invisible up to what is left at the greatest depth", "[extremes]") {
    Scene scene;
    Material glass;
    glass.reflectance = glass.transmittance = Color(1), glass.ior = 1.5;
    scene.materials = {glass};
    scene.shapes.push_back({Sphere{vec3(0), 1}, 0, vec3(0)});
    scene.environment = Color(1);
    scene.camera.eye = {0, 0, 3};
    scene.camera.tan_half_fov = 0.36;
    scene.camera.size = {32, 32};
    scene.samples = 1;
    scene.sampler = Sampler::uniform;  // the middle of each pixel
    Greatest off;
    for (const int depth : {1, 4, 8, 16, 24}) {
        scene.depth = depth;
        const Image image = picture(scene);
        for (int y = 0; y < 32; ++y)
            for (int x = 0; x < 32; ++x) {
                // Inside, the light meets the glass at the same angle each time: of the 1 - R that comes in, R is left
                // each time.
                const Ray ray = camera_ray(scene.camera, {x + 0.5, y + 0.5});
                const Real t = hit_sphere({vec3(0), 1}, ray);
                const Real r =
                    t < inf ? fresnel_dielectric(-dot(ray.direction, unit(ray.origin + t * ray.direction)), 1, 1.5) : 0;
                const Real tail = t < inf ? (1 - r) * std::pow(r, depth - 1) : 0;
                off.see(std::abs(1 - tail - image.at(x, y).x));
            }
    }
    figure(52, "glass ball against 1 - (1 - R) R^(depth - 1)", off.value, 1e-11);

    // Each path one way only, to an end where hardly any light is left: with a bubble beside the ball, both ways at
    // each surface would be more rays than fit anywhere.
    scene.depth = 1 << 20;
    scene.shapes.push_back({Sphere{vec3(0, 1.2, -1), 0.9}, 1, vec3(0)});
    scene.materials.push_back(glass);
    scene.materials[1].ior = 1 / 1.5;
    const Flat all = flatness(picture(scene));
    figure(52, "glass ball and bubble, followed to the end", std::max(all.off, std::abs(all.mean - 1)), 1e-11);
}

TEST_CASE("53 facing mirrors, reflectance 1 - 1e-6, depth 1e6: the sum of all images, iteratively", "[extremes]") {
    Material mirror;
    mirror.reflectance = Color(1 - 1e-6), mirror.emission = Color(2);
    Scene scene;
    scene.materials = {mirror};
    scene.shapes.push_back({Quad{{0, 0, -1}, {1, 0, 0}, {0, 1, 0}}, 0, vec3(0)});
    scene.shapes.push_back({Quad{{0, 0, 1}, {0, 1, 0}, {1, 0, 0}}, 0, vec3(0)});
    scene.camera.size = {1, 1};
    scene.samples = 1;
    scene.sampler = Sampler::uniform;  // straight ahead
    scene.depth = 1000000;
    const Flat image = flatness(picture(scene));
    const Real due = geometric(2, 1 - 1e-6, scene.depth + 1);
    figure(53, "facing mirrors, depth 1e6, relative", std::abs(image.mean / due - 1), 1e-10);
}

TEST_CASE("54 a closed cavity, albedo 0.5 to 1 - 1e-5: E(1 - a^(D+1))/(1 - a), each path alike", "[extremes]") {
    Greatest worst, spread;
    const std::pair<Real, int> cases[] = {{0.5, 64}, {0.8, 200}, {0.99, 4000}, {1 - 1e-3, 40000}, {1 - 1e-5, 300000}};
    for (const auto& [albedo, bounces] : cases) {
        Material m;
        m.albedo = Color(albedo), m.emission = Color(3), m.sampled = false;
        Scene scene = room(m);
        scene.bounces = bounces;
        scene.roulette = false;  // all of them
        const Flat image = flatness(picture(scene));
        const Real due = geometric(3, albedo, bounces + 1);
        worst.see(std::abs(image.mean / due - 1));
        spread.see(image.off / due);
    }
    figure(54, "cavity, relative", worst.value, 1e-11);
    figure(54, "cavity, largest difference of two paths, relative", spread.value, 1e-14);
}

TEST_CASE("55 a path that is ended at random with its probability, and one that never is: the same mean",
          "[extremes]") {
    // A student's color_bleeding may have a roulette of its own.
    Random random(55);
    const Real albedo = 0.9;
    Sum ended, squares;
    const int paths = 400000;
    for (int k = 0; k < paths; ++k) {
        Real weight = 1, light = 0;
        for (int bounce = 0; bounce < 400; ++bounce) {
            light += weight;
            if (!(random.number() < albedo)) break;
            weight *= color_bleeding({0, 0, 1}, Color(albedo), random.point()).weight.x / albedo;
        }
        ended.add(light), squares.add(light * light);
    }
    const Real mean = ended.value() / paths, variance = squares.value() / paths - mean * mean,
               due = geometric(1, albedo, 401);
    figure(55, "roulette against none, in standard errors", std::abs(mean - due) / std::sqrt(variance / paths), 4);
}

TEST_CASE("57 a medium of optical depth 1e-9 to 1e4 and albedo 1 in a furnace: within its error", "[extremes]") {
    for (const Real optical_depth : {1e-9, 1e-3, 1.0, 10.0, 100.0, 1e4}) {
        Material milk;
        milk.transmittance = Color(1), milk.medium = {optical_depth / 2, Color(1), 0.0};
        Scene scene;
        scene.materials = {milk};
        scene.shapes.push_back({Sphere{vec3(0), 1}, 0, vec3(0)});
        scene.environment = Color(1);
        scene.camera.eye = {0, 0, 3};
        scene.camera.tan_half_fov = 0.2;
        scene.camera.size = {8, 8};
        scene.samples = 16;
        const Flat image = flatness(picture(scene));
        // Walks of more than 2^20 steps are given up: at 1e4 one in a thousand.
        figure(
            57,
            "medium of optical depth 1e" + std::to_string(int(std::round(std::log10(optical_depth)))) + ": light lost",
            std::abs(1 - image.mean), optical_depth > 1000 ? 5e-3 : 1e-12);
    }
}
