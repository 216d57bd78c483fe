#include "checks/kit/lobe_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "checks/kit/later.h"
#include "statistics/blob.h"
#include "statistics/closed_forms.h"

namespace grade {

namespace {

/// (cos, sin) of so many parts of a turn.
template <int turns>
std::array<rt::vec2, turns> circle() {
    std::array<rt::vec2, turns> points;
    for (int k = 0; k < turns; ++k) {
        const double turn = 2 * rt::pi * k / turns;
        points[std::size_t(k)] = {std::cos(turn), std::sin(turn)};
    }
    return points;
}

}  // namespace

double lobe_light(const Lobe& lobe, const rt::Sphere& lamp, rt::vec3 p) {
    constexpr int rings = 8, turns = 16;
    static const std::array around = circle<turns>();
    const rt::vec3 to_lamp = lamp.center - p;
    const double sine2 = rt::sqr(lamp.radius) / rt::dot(to_lamp, to_lamp),
                 cap = 1 - std::sqrt(1 - sine2);  // 1 - cos of the cone
    const rt::Frame frame = rt::frame_about(rt::unit(to_lamp));
    double sum = 0;
    for (int i = 0; i < rings; ++i)
        for (const rt::vec2 turn : around) {
            const double c = 1 - cap * (i + 0.5) / rings, s = std::sqrt(1 - c * c);
            const rt::vec3 w = frame.to_world({s * turn.x, s * turn.y, c});
            const double along = rt::dot(w, lobe.axis), cosine = rt::dot(w, lobe.outward);
            if (along > 0 && cosine > 0) sum += std::pow(along, lobe.exponent) * cosine;
        }
    return lobe.share * (lobe.exponent + 2) / (2 * rt::pi) * sum * 2 * rt::pi * cap / (rings * turns);
}

namespace {

Blob due_moments(const LobeSurface& surface, const rt::Sphere& lamp, double exponent) {
    return moments_of_middles(surface.camera, [&](rt::vec2 film) {
        const Lobe lobe = surface.lobe(view_direction(surface.camera, film), exponent);
        return lobe_light(lobe, lamp, seen_on_plane(surface.camera, film, surface.point, surface.normal));
    });
}

}  // namespace

std::vector<Statistic> blurred_lamp(const LobeSurface& surface, const rt::Sphere& lamp, double n,
                                    const std::string& lobe_about) {
    const auto due = later([=] { return due_moments(surface, lamp, n); });
    const auto width_of = [=](double wrong) {
        return due_moments(surface, lamp, wrong).radial_square / due().radial_square;
    };
    const auto place = [&](const std::string& what, int axis) {
        return of_picture(
            {.id = "P1",
             .what = what,
             .number = [=](const rt::Image& image) { return blob_of(image).centroid[axis] - due().centroid[axis]; },
             .truth = 0,
             .delta = 0.8,
             .hint =
                 [=](double value, double) {
                     return fmt::format(
                         "the blurred lamp is {:.3g} pixels from where it must be: is the lobe about {}?",
                         std::abs(value), lobe_about);
                 }});
    };
    return {of_picture(
                {.id = "P2",
                 .what = "light of the blurred lamp, over what must be",
                 .number = [=](const rt::Image& image) { return blob_of(image).mass / due().mass; },
                 .delta = 0.06,
                 .hint = by_ratio(
                     "the light of the blurred lamp",
                     {{(n + 1) / (n + 2), "does n + 1 stand for n + 2 in the BRDF?"},
                      {(n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
                      {0, "does a ray of the lobe ever meet it?"}},
                     fmt::format("is the lobe about {}, and the weight BRDF x cosine / density?", lobe_about))}),
            place("blurred lamp, right of where it must be [pixel]", 0),
            place("blurred lamp, below where it must be [pixel]", 1),
            of_picture(
                {.id = "P1",
                 .what = "mean square width of the blurred lamp, over what must be",
                 .number = [=](const rt::Image& image) { return blob_of(image).radial_square / due().radial_square; },
                 .delta = 0.06,
                 .hint = hint_later([=] {  // each width is a picture
                     return by_ratio("the mean square width of the blurred lamp",
                                     {{width_of(2 * n), "is the exponent 2n?"},
                                      {width_of(n / 2), "is the exponent n/2?"},
                                      {width_of(n + 1), "is the exponent n + 1?"},
                                      {width_of(n - 1), "is the exponent n - 1?"}});
                 })})};
}

std::function<double(double)> tabulated_albedo(double exponent) {
    constexpr int steps = 45;
    const auto table = later([exponent] {
        std::vector<double> values;
        for (int i = 0; i <= steps; ++i) values.push_back(phong_albedo(exponent, rt::pi / 2 * i / steps));
        return values;
    });
    return [table](double angle) {
        const double at = std::clamp(angle / (rt::pi / 2) * steps, 0.0, steps - 1e-9), share = at - std::floor(at);
        return (1 - share) * table()[std::size_t(at)] + share * table()[std::size_t(at) + 1];
    };
}

}  // namespace grade
