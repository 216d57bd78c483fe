#include "checks/kit/scene.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::vec3;

/// A ball, a box of quads and a tetrahedron under two lights, as large as `size`.
std::string still_life(double size) {
    const auto at = [&](double x, double y, double z) { return size * vec3(x, y, z); };
    const View view{at(0.3, 1.6, 5), at(0, 0.6, 0), {0, 1, 0}, 40, {32, 24}};
    return toml(view) + material("white", {{"albedo", 0.7}}) +
           material("gloss", {{"albedo", vec3(0.3, 0.4, 0.5)}, {"specular", 0.2}, {"shininess", 20}}) +
           material("lamp", {{"emission", 8}}) + quad("white", at(0, 0, 0), at(4, 0, 0), at(0, 0, -4)) +
           sphere("gloss", at(-0.8, 0.7, 0), 0.7 * size) +
           triangle("white", at(0.3, 0.01, 0.8), at(1.9, 0.01, 0.2), at(1.1, 1.5, 0)) +
           quad("lamp", at(0.5, 3, 0.5), at(0.5, 0, 0), at(0, 0, 0.5)) +
           point_light(at(-2, 2.5, 2), vec3(20 * size * size, 0, 0));
}

/// The share of pixels which are not what they are at size 1.
double scene_size(double x, Generator&, const Asker& ask) {
    const rt::Image one = ask.render(still_life(1), 4), other = ask.render(still_life(x), 4);
    int off = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        const double difference = rt::largest(other.pixels[i] - one.pixels[i]);
        off += !(difference <= 1e-5 * (1 + rt::largest(one.pixels[i])));
    }
    return off / double(one.pixels.size());
}

/// A closed box that shines and reflects all but x of the light: the sum of the bounces.
double furnace(double x, Generator&, const Asker& ask) {
    const double albedo = 1 - x;
    const int bounces = int(std::min(3 / x, 1e6));
    const View view{{0.1, 0.2, 0.3}, {1, 0.3, 0.1}, {0, 1, 0}, 60, {3, 3}};
    std::string text = scene_table("[render]", {{"bounces", bounces}, {"roulette", false}}) + toml(view) +
                       material("wall", {{"albedo", albedo}, {"emission", 1}, {"sampled", false}});
    for (int side = 0; side < 6; ++side) {
        vec3 n(0), u(0), v(0);
        n[side / 2] = side % 2 ? -1 : 1, u[(side / 2 + 1) % 3] = 1, v[(side / 2 + 2) % 3] = side % 2 ? -1 : 1;
        text += quad("wall", -n, u, v);
    }
    const rt::Image image = ask.render(text, 1);
    const double truth = -std::expm1((bounces + 1.0) * std::log1p(-(1 - albedo))) / (1 - albedo);
    double worst = 0;
    for (const rt::Color& pixel : image.pixels) worst = worse_error(worst, std::abs(pixel.x / truth - 1));
    return worst;
}

}  // namespace

std::vector<Family> picture_families() {
    return {Family("scene_size",
                   {"shadow_ray", "camera_ray", "hit_sphere", "hit_quad", "hit_triangle", "point_irradiance", "phong",
                    "light_sample", "direct_light"},
                   "size of a whole scene [m]", "share of pixels that change",
                   {.tolerance = 5e-3, .bound = 5e-3, .decades = sweep(-30, 30, 3)}, scene_size),
            Family("furnace", {"color_bleeding", "camera_ray", "hit_quad", "emission_counts", "cosine_hemisphere"},
                   "1 - albedo of a closed box", "relative error",
                   {.tolerance = 1e-10, .bound = 1e-10, .decades = sweep(-5, -1), .scored = {}}, furnace)};
}

}  // namespace grade::stress
