#include "checks/kit/shadow_scene.h"

#include <algorithm>

#include "checks/kit/later.h"
#include "checks/kit/render_check.h"
#include "statistics/closed_forms.h"
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
    const double vfov = vfov_of(half_view * size.y / size.x, camera_height);
    std::string scene = toml(View{place({0, 0, camera_height}), place({0, 0, 0}), y, vfov, size}) +
                        material("floor", {{"albedo", s.albedo}, {"specular", s.specular}}) + material("black", {}) +
                        place.floor("floor", 5) + quad("black", place({-2.5, 0, s.blocker_height}), 2.5 * x, 5.0 * y) +
                        place.floor("black", 5, s.light_height + 0.7);
    const vec3 light = place({0, 0, s.light_height});
    if (!s.kind) return scene + point_light(light, s.radiance);
    scene += material("lamp", {{"emission", s.radiance}});
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

namespace {

/// Radiance of the floor at p by a disc or a sphere, from a grid of equal parts: of the disc's area, or of the solid
/// angle of the sphere's cone. seen(light) says whether a point of the light is not hidden.
template <class Seen>
double radiance_by_round(const ShadowScene& s, vec3 p, Seen seen) {
    constexpr int rings = 12, turns = 24;
    const vec3 to_center = vec3(0, 0, s.light_height) - p;
    const double distance = glm::length(to_center), cap = 1 - std::sqrt(1 - rt::sqr(s.half_width / distance));
    const rt::Frame frame = rt::frame_about(to_center / distance);
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < turns; ++j) {
            const double share = (i + 0.5) / rings, turn = 2 * rt::pi * (j + 0.5) / turns;
            if (*s.kind == Kind::disc) {
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

/// What a picture of the scene must show.
struct Due {
    std::vector<double> expected, unblocked;  // brightness of each column, with and without the blocker
    double reach;                             // columns from the middle that the penumbra may take
    Spread penumbra;
    Region umbra, open;  // columns that are dark or lit throughout, and one column away from the others
    double light = 0;    // of the open floor
};

Due due_of(const ShadowScene& s, const rt::Camera& camera, double camera_height) {
    Due due;
    due.expected = expected_profile(s, camera, camera_height, true);
    due.unblocked = expected_profile(s, camera, camera_height, false);
    // twice the penumbra: one that is twice too wide is still measured
    const double metre = 2 * camera_height * camera.tan_half_fov / size.y;
    due.reach = 1.05 * penumbra_of(s) / metre;
    due.penumbra = penumbra(due.expected, due.unblocked, due.reach);
    int dark = 0, lit = size.x;
    while (dark < size.x && due.expected[dark] == 0) ++dark;
    while (lit > 0 && due.expected[lit - 1] > 0.9999 * due.unblocked[lit - 1]) --lit;
    due.umbra = {0, 0, dark - 1, size.y}, due.open = {lit + 1, 0, size.x - lit - 1, size.y};
    for (int k = due.open.x; k < size.x; ++k) due.light += due.unblocked[k] / due.open.width;
    return due;
}

double brightest(const rt::Image& image, const Region& region) {
    double most = 0;
    for (int y = 0; y < region.height; ++y)
        for (int x = 0; x < region.width; ++x) most = std::max(most, brightness(image.at(x, y)));
    return most;
}

}  // namespace

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
    if (*s.kind != Kind::quad) return radiance_by_round(s, p, seen);
    const double edge = blocked ? x * (1 - s.light_height / s.blocker_height) : -s.half_width;
    const double low = std::clamp(edge, -s.half_width, s.half_width);
    if (low >= s.half_width) return 0;
    const rt::Quad part{
        {(low + s.half_width) / 2, 0, s.light_height}, {(s.half_width - low) / 2, 0, 0}, {0, -s.half_length, 0}};
    return s.albedo / rt::pi * s.radiance * quad_irradiance(part, p, up);
}

Check shadow_check(Generator& random, const std::string& name, const ShadowScene& s) {
    const double camera_height = 0.8 * s.blocker_height;
    const std::string scene = text(random, s, camera_height);
    const auto due = later([=] { return due_of(s, camera_of(scene), camera_height); });
    const auto edge = [=](const rt::Image& image) {
        return penumbra(column_profile(image, whole(image)), due().unblocked, due().reach);
    };
    std::vector<Statistic> statistics = {
        of_picture({.id = "L4",
                    .what = "brightest pixel of the umbra",
                    .number = [=](const rt::Image& image) { return brightest(image, due().umbra); },
                    .truth = 0,
                    .exact = true,
                    .hint = always("light falls into the umbra, where the blocker hides the whole light")}),
        of_picture(
            {.id = "L1",
             .what = "light of the open floor, over what must be",
             .number = [=](const rt::Image& image) { return brightness(region_mean(image, due().open)) / due().light; },
             .delta = 0.04,
             .hint = by_ratio(
                 "the light of the open floor",
                 {{0, "all is in shadow: is the shadow ray bounded by the light, and does it start off the surface?"},
                  {0.25, "a quarter of the light is sampled, or its area is too small by 4"},
                  {4, "its area is too large by 4"},
                  {2, "is a factor 2 in the density?"},
                  {0.5, "is a factor 1/2 in the density?"}},
                 "is the density per solid angle that of the sample?")})};
    if (s.kind)
        statistics.push_back(of_picture(
            {.id = "L3",
             .what = "width of the penumbra, over what must be",
             .number =
                 [=](const rt::Image& image) {
                     return std::sqrt(std::max(0.0, edge(image).variance) / due().penumbra.variance);
                 },
             .delta = 0.05,
             .hint = by_ratio("the width of the penumbra",
                              {{2, "is a half width or a radius used as the whole?"},
                               {0.5, "is the light's half-width used as its width, or its diameter as its radius?"},
                               {0.816, "samples crowd in the middle of the light"}},
                              "are samples spread evenly over the light?")}));
    statistics.push_back(of_picture(
        {.id = "L3",
         .what = "place of the shadow's edge, off by [pixel]",
         .number = [=](const rt::Image& image) { return edge(image).mean - due().penumbra.mean; },
         .truth = 0,
         .delta = 0.6,
         .hint = always("the shadow's edge is shifted: the light is sampled more on one side, or the ray starts too "
                        "far from the floor")}));
    return render_check(name, {scene, 32, "sobol"}, statistics);
}

}  // namespace grade
