#include <fmt/format.h>

#include "stress/family.h"

namespace grade {

namespace {

/// A ball, a box of quads and a tetrahedron under two lights, as large as `size`.
std::string still_life(double size) {
    const auto at = [&](double x, double y, double z) {
        return fmt::format("[{:#.17g}, {:#.17g}, {:#.17g}]", x * size, y * size, z * size);
    };
    std::string text =
        fmt::format("[camera]\neye = {}\ntarget = {}\nvfov = 40\nsize = [32, 24]\n", at(0.3, 1.6, 5), at(0, 0.6, 0));
    text +=
        "[materials.white]\nalbedo = [0.7, 0.7, 0.7]\n[materials.gloss]\nalbedo = [0.3, 0.4, 0.5]\nspecular = [0.2, "
        "0.2, 0.2]\nshininess = 20\n";
    text += "[materials.lamp]\nemission = [8, 8, 8]\n";
    text += fmt::format("[[shape]]\ntype = \"quad\"\ncenter = {}\nu = {}\nv = {}\nmaterial = \"white\"\n", at(0, 0, 0),
                        at(4, 0, 0), at(0, 0, -4));
    text += fmt::format("[[shape]]\ntype = \"sphere\"\ncenter = {}\nradius = {:#.17g}\nmaterial = \"gloss\"\n",
                        at(-0.8, 0.7, 0), 0.7 * size);
    text += fmt::format("[[shape]]\ntype = \"triangle\"\na = {}\nb = {}\nc = {}\nmaterial = \"white\"\n",
                        at(0.3, 0.01, 0.8), at(1.9, 0.01, 0.2), at(1.1, 1.5, 0));
    text += fmt::format("[[shape]]\ntype = \"quad\"\ncenter = {}\nu = {}\nv = {}\nmaterial = \"lamp\"\n",
                        at(0.5, 3, 0.5), at(0.5, 0, 0), at(0, 0, 0.5));
    text += fmt::format("[[light]]\ntype = \"point\"\nposition = {}\nintensity = [{:#.17g}, 0, 0]\n", at(-2, 2.5, 2),
                        20 * size * size);
    return text;
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
    std::string text = fmt::format(
        "[render]\nbounces = {}\n[camera]\neye = [0.1, 0.2, 0.3]\ntarget = [1, 0.3, 0.1]\nvfov = 60\nsize = [3, 3]\n",
        bounces);
    text += fmt::format(
        "[materials.wall]\nalbedo = [{0:#.17g}, {0:#.17g}, {0:#.17g}]\nemission = [1, 1, 1]\nsampled = false\n",
        albedo);
    for (int side = 0; side < 6; ++side) {
        rt::vec3 n(0), u(0), v(0);
        n[side / 2] = side % 2 ? -1 : 1, u[(side / 2 + 1) % 3] = 1, v[(side / 2 + 2) % 3] = side % 2 ? -1 : 1;
        text += fmt::format(
            "[[shape]]\ntype = \"quad\"\ncenter = [{}, {}, {}]\nu = [{}, {}, {}]\nv = [{}, {}, {}]\nmaterial = "
            "\"wall\"\n",
            -n.x, -n.y, -n.z, u.x, u.y, u.z, v.x, v.y, v.z);
    }
    const rt::Image image = ask.render(text, 1);
    const double truth = -std::expm1((bounces + 1.0) * std::log1p(-(1 - albedo))) / (1 - albedo);
    double worst = 0;
    for (const rt::Color& pixel : image.pixels) worst = worse_error(worst, std::abs(pixel.x / truth - 1));
    return worst;
}

}  // namespace

std::vector<Family> picture_families() {
    return {
        {"scene_size",
         {"shadow_ray", "camera_ray", "hit_sphere", "hit_quad", "hit_triangle", "point_irradiance", "phong",
          "light_sample", "direct_light"},
         "size of a whole scene [m]",
         "share of pixels that change",
         5e-3,
         5e-3,
         sweep(-30, 30, 3),
         {-3, 3},
         scene_size},
        {"furnace",
         {"color_bleeding", "camera_ray", "hit_quad", "emission_counts", "cosine_hemisphere"},
         "1 - albedo of a closed box",
         "relative error",
         1e-10,
         1e-10,
         sweep(-5, -1),
         {},
         furnace},
    };
}

}  // namespace grade
