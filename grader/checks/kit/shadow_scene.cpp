#include "checks/kit/shadow_scene.h"

#include <fmt/format.h>

#include <algorithm>

#include "checks/kit/draw.h"
#include "checks/kit/render_check.h"
#include "rt/files/scene_reader.h"
#include "statistics/irradiance.h"
#include "statistics/projection.h"
#include "statistics/spread.h"

namespace grade {

namespace {

using rt::vec3;
using Kind = rt::Emitter::Kind;
constexpr rt::ivec2 size{48, 12};

std::string text(Generator& random, const ShadowScene& s, double camera_height) {
    const Place place = any_place(random);
    const vec3 x = place.axes.x, y = place.axes.y, z = place.axes.z;
    const double half_view = 1.6 * penumbra_of(s) + 0.35;  // of the floor, across the edge
    const double vfov = 2 * std::atan(half_view * size.y / size.x / camera_height) * 180 / rt::pi;
    const View view{place({0, 0, camera_height}), place({0, 0, 0}), y, vfov, size};
    std::string scene =
        toml(view) + fmt::format("[materials.floor]\nalbedo = {}\n\n[materials.black]\n\n", toml(s.albedo));
    scene += quad("floor", place({0, 0, 0}), 5.0 * x, 5.0 * y);
    scene += quad("black", place({-2.5, 0, s.blocker_height}), 2.5 * x, 5.0 * y);
    scene += quad("black", place({0, 0, s.light_height + 0.7}), 5.0 * x, 5.0 * y);
    const vec3 light = place({0, 0, s.light_height});
    if (!s.kind)
        return scene + fmt::format("[[light]]\ntype = \"point\"\nposition = {}\nintensity = {}\n\n", toml(light),
                                   toml(s.radiance));
    scene += fmt::format("[materials.lamp]\nemission = {}\n\n", toml(s.radiance));
    if (*s.kind == Kind::quad) return scene + quad("lamp", light, s.half_width * x, -s.half_length * y);
    if (*s.kind == Kind::disc) return scene + disc("lamp", light, -z, s.half_width);
    return scene + sphere("lamp", light, s.half_width);
}

/// The mean of each column of the picture that must come out.
std::vector<double> expected_profile(const ShadowScene& s, const rt::Camera& camera, double camera_height,
                                     bool blocked) {
    constexpr int across = 4, along = 2;  // points of a pixel's width, and of the column
    const double metre = 2 * camera_height * camera.tan_half_fov / size.y;  // a pixel on the floor
    std::vector<double> profile(size.x, 0);
    for (int column = 0; column < size.x; ++column)
        for (int i = 0; i < across; ++i)
            for (int j = 0; j < along; ++j) {
                const double x = (column + (i + 0.5) / across - 0.5 * size.x) * metre,
                             y = ((j + 0.5) / along - 0.5) * size.y * metre;
                profile[column] += floor_radiance(s, x, y, blocked) / (across * along);
            }
    return profile;
}

/// The line spread of the penumbra: of the share of the light that is let through. Columns far from the edge only add
/// noise: beyond `reach` from the middle they count as dark and as fully lit.
Spread penumbra(const std::vector<double>& profile, const std::vector<double>& unblocked, double reach) {
    std::vector<double> share;
    double lit = 0, count = 0;
    for (std::size_t k = 0; k < profile.size(); ++k) share.push_back(profile[k] / unblocked[k]);
    for (std::size_t k = 0; k < share.size(); ++k)
        if (double(k) > 0.5 * size.x + reach) lit += share[k], ++count;
    for (std::size_t k = 0; k < share.size(); ++k) {
        if (double(k) + 1 < 0.5 * size.x - reach) share[k] = 0;
        if (double(k) > 0.5 * size.x + reach) share[k] = lit / count;
    }
    return edge_spread(share);
}

}  // namespace

double penumbra_of(const ShadowScene& s) {
    return s.kind ? penumbra_width(2 * s.half_width, s.light_height, s.blocker_height) : 0.2;
}

ShadowScene any_shadow(Generator& random, std::optional<Kind> kind) {
    ShadowScene s;
    s.kind = kind;
    s.light_height = between(random, 1.8, 2.4);
    s.blocker_height = s.light_height * between(random, 0.42, 0.55);
    s.half_width = between(random, 0.18, 0.3);
    s.half_length = between(random, 0.15, 0.4);
    s.albedo = between(random, 0.4, 0.9);
    s.radiance = between(random, 3, 8);
    return s;
}

double floor_radiance(const ShadowScene& s, double x, double y, bool blocked) {
    const vec3 p(x, y, 0), up(0, 0, 1);
    // a point of the light is seen where the way to it passes the edge, x = 0 at the blocker's height
    const auto seen = [&](vec3 light) { return !blocked || x + (light.x - x) * s.blocker_height / light.z > 0; };
    if (!s.kind) {
        const vec3 to(-x, -y, s.light_height);
        const double squared = rt::dot(to, to);
        return seen({0, 0, s.light_height})
                   ? s.albedo / rt::pi * s.radiance * s.light_height / (squared * std::sqrt(squared))
                   : 0;
    }
    if (*s.kind == Kind::quad) {
        const double edge = blocked ? x * (1 - s.light_height / s.blocker_height) : -s.half_width;
        const double low = std::clamp(edge, -s.half_width, s.half_width);
        if (low >= s.half_width) return 0;
        const rt::Quad part{
            {(low + s.half_width) / 2, 0, s.light_height}, {(s.half_width - low) / 2, 0, 0}, {0, -s.half_length, 0}};
        return s.albedo / rt::pi * s.radiance * quad_irradiance(part, p, up);
    }
    // by a grid of equal parts: of the disc's area, or of the solid angle of the sphere's cone
    constexpr int rings = 12, turns = 24;
    const bool is_disc = *s.kind == Kind::disc;
    const vec3 to_center = vec3(0, 0, s.light_height) - p;
    const double distance = glm::length(to_center), cap = 1 - std::sqrt(1 - rt::sqr(s.half_width / distance));
    const rt::Frame frame = rt::frame_about(to_center / distance);
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < turns; ++j) {
            const double share = (i + 0.5) / rings, turn = 2 * rt::pi * (j + 0.5) / turns;
            if (is_disc) {
                const double r = s.half_width * std::sqrt(share);
                const vec3 light(r * std::cos(turn), r * std::sin(turn), s.light_height), to = light - p;
                if (seen(light)) sum += rt::pi * rt::sqr(s.half_width) * rt::sqr(to.z) / rt::sqr(rt::dot(to, to));
            } else {
                const double cosine = 1 - share * cap, sine = std::sqrt(1 - cosine * cosine);
                const vec3 d = frame.to_world({sine * std::cos(turn), sine * std::sin(turn), cosine});
                if (seen(p + s.light_height / d.z * d)) sum += 2 * rt::pi * cap * d.z;
            }
        }
    return s.albedo / rt::pi * s.radiance * sum / (rings * turns);
}

Check shadow_check(Generator& random, const std::string& name, const ShadowScene& s) {
    const double camera_height = 0.8 * s.blocker_height;
    const std::string scene = text(random, s, camera_height);
    const rt::Camera camera = rt::parse_scene(scene, name).camera;
    const std::vector<double> expected = expected_profile(s, camera, camera_height, true);
    const std::vector<double> unblocked = expected_profile(s, camera, camera_height, false);
    // twice the penumbra: one that is twice too wide is still measured
    const double metre = 2 * camera_height * camera.tan_half_fov / size.y, reach = 1.05 * penumbra_of(s) / metre;
    const Spread due = penumbra(expected, unblocked, reach);

    // columns that are dark or lit throughout, and one column away from the others
    int dark = 0, lit = size.x;
    while (dark < size.x && expected[dark] == 0) ++dark;
    while (lit > 0 && expected[lit - 1] > 0.9999 * unblocked[lit - 1]) --lit;
    const Region umbra{0, 0, dark - 1, size.y}, open{lit + 1, 0, size.x - lit - 1, size.y};
    double light = 0;
    for (int k = open.x; k < size.x; ++k) light += unblocked[k] / open.width;

    Statistic darkness = of_picture("L4", "brightest pixel of the umbra", [=](const rt::Image& image) {
        double most = 0;
        for (int y = 0; y < umbra.height; ++y)
            for (int x = 0; x < umbra.width; ++x) most = std::max(most, brightness(image.at(x, y)));
        return most;
    }, 0, 0, always("light falls into the umbra, where the blocker hides the whole light"));
    darkness.exact = true;
    Statistic brightness_of_lit = of_picture(
        "L1", "light of the open floor, over what must be",
        [=](const rt::Image& image) { return brightness(region_mean(image, open)) / light; }, 1, 0.04,
        by_ratio("the light of the open floor",
                 {{0, "all is in shadow: is the shadow ray bounded by the light, and does it start off the surface?"},
                  {0.25, "a quarter of the light is sampled, or its area is too small by 4"},
                  {4, "its area is too large by 4"},
                  {2, "is a factor 2 in the density?"},
                  {0.5, "is a factor 1/2 in the density?"}},
                 "is the density per solid angle that of the sample?"));
    Statistic place = of_picture(
        "L3", "place of the shadow's edge, off by [pixel]",
        [=](const rt::Image& image) {
            return penumbra(column_profile(image, whole(image)), unblocked, reach).mean - due.mean;
        },
        0, 0.6,
        always("the shadow's edge is shifted: the light is sampled more on one side, or the ray starts too far from "
               "the floor"));
    if (!s.kind) return render_check(name, {scene, 32, "sobol"}, {darkness, brightness_of_lit, place});
    Statistic width = of_picture(
        "L3", "width of the penumbra, over what must be",
        [=](const rt::Image& image) {
            return std::sqrt(std::max(0.0, penumbra(column_profile(image, whole(image)), unblocked, reach).variance) /
                             due.variance);
        },
        1, 0.05,
        by_ratio("the width of the penumbra",
                 {{2, "is a half width or a radius used as the whole?"},
                  {0.5, "is the light's half-width used as its width, or its diameter as its radius?"},
                  {0.816, "samples crowd in the middle of the light"}},
                 "are samples spread evenly over the light?"));
    return render_check(name, {scene, 32, "sobol"}, {darkness, brightness_of_lit, width, place});
}

}  // namespace grade
