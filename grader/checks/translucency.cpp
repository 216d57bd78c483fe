#include "asked/translucency.h"
#include "checks/kit/lobe_check.h"
#include "checks/kit/lobe_picture.h"

namespace grade {

namespace {

using rt::vec3;

/// Share of unpolarised light that a surface of glass transmits.
double transmitted_share(double angle, double ior) {
    const double c = std::cos(angle), t = std::sqrt(1 - rt::sqr(std::sin(angle) / ior));
    const double s = (c - ior * t) / (c + ior * t), p = (ior * c - t) / (ior * c + t);
    return 1 - (s * s + p * p) / 2;
}

/// The lobe of a ray of direction d that enters glass with the given normal.
Lobe entering(vec3 d, vec3 normal, double ior, double exponent) {
    const double cosine = -rt::dot(d, normal), sine = rt::safe_sqrt(1 - cosine * cosine);
    const vec3 along = (d + cosine * normal) / ior;
    return {along - std::sqrt(1 - sine * sine / (ior * ior)) * normal, -normal, exponent,
            transmitted_share(std::acos(std::min(cosine, 1.0)), ior)};
}

std::string frosted(double ior, double exponent) {
    return material("frosted", {{"transmittance", 1}, {"ior", ior}, {"exponent", exponent}});
}

/// Frosted glass before a sky of light, seen at all angles: part of the lobe does not cross the surface.
Check sky(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 6, 12), ior = between(random, 1.3, 1.7), around = log_between(random, 0.3, 3);
    // 15 to 75 degrees from the normal
    const View view{place({-1, 0, 1}), place({0, 0, 0}), place.turned({0, 0, 1}), 60, {48, 48}};
    const std::string scene = toml(view) + unsampled_lamp("sky", around) + frosted(ior, n) +
                              place.floor("frosted", 100) + disc("sky", place({0, 0, -0.1}), place.axes.z, 10000);
    const rt::Camera camera = camera_of(scene);
    const auto albedo = tabulated_albedo(n);
    const auto angle_at = [=](int x, int y) {
        return std::acos(-rt::dot(view_direction(camera, {x + 0.5, y + 0.5}), place.axes.z));
    };
    const auto refracted = [=](double angle) { return std::asin(std::sin(angle) / ior); };
    const auto seen_at = [&](const std::string& id, const std::string& where, double low, double high, double degrees) {
        const PictureNumber over_due = light_over_due(
            camera.size,
            [=](int x, int y) {
                const double angle = angle_at(x, y) * 180 / rt::pi;
                return angle >= low && angle <= high;
            },
            brightness,
            [=](int x, int y) { return transmitted_share(angle_at(x, y), ior) * albedo(refracted(angle_at(x, y))); });
        return of_picture(
            {.id = id,
             .what = "light let through " + where + ", over what must be",
             .number = [=](const rt::Image& image) { return over_due(image) / around; },
             .delta = 0.05,
             .hint = hint_later([=] {
                 const double angle = degrees * rt::pi / 180, due = albedo(refracted(angle));
                 const double swapped = std::min(rt::pi / 2, std::asin(std::min(1.0, std::sin(angle) * ior)));
                 return by_ratio(
                     "what frosted glass lets through " + where,
                     {{albedo(angle) / due, "is the lobe about the direction of travel? It must be refracted"},
                      {albedo(swapped) / due, "are the two indices of refraction exchanged?"},
                      {(n + 1) / (n + 2), "does n + 1 stand for n + 2 in the BTDF?"},
                      {(n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
                      {1 / due,
                       "does the weight have the cosine at the surface, and is it 0 where the ray does not cross?"}},
                     "expected (n + 2)/(2 pi) cos(alpha)^n x |cosine at the surface| / density, 0 where the ray does "
                     "not cross");
             })});
    };
    return render_check("sky", {scene, 8, "sobol"},
                        {seen_at("P2", "where it is seen steeply", 0, 30, 24),
                         seen_at("P3", "where it is seen at 65 degrees", 60, 70, 65)});
}

/// The blurred image of a lamp behind frosted glass.
Check lamp_behind(Generator& random) {
    const Place place = any_place(random);
    const double n = between(random, 8, 14), ior = between(random, 1.3, 1.7), angle = between(random, 0.6, 0.9),
                 inside = std::asin(std::sin(angle) / ior);
    const rt::Sphere shining{place({4 * std::sin(inside), 0, -4 * std::cos(inside)}), 0.9};
    const View view{
        place({-4 * std::sin(angle), 0, 4 * std::cos(angle)}), place({0, 0, 0}), place.turned({0, 0, 1}), 50, {24, 24}};
    const std::string scene = toml(view) + unsampled_lamp("lamp", 1) + frosted(ior, n) +
                              sphere("lamp", shining.center, shining.radius) + place.floor("frosted", 100);
    const vec3 up = place.axes.z;
    const LobeSurface pane{camera_of(scene), place.origin, up,
                           [=](vec3 d, double exponent) { return entering(d, up, ior, exponent); }};
    return render_check("lamp", {scene, 64, "sobol"}, blurred_lamp(pane, shining, n, "the refracted direction"));
}

Check refracted_rays(Generator& random, const std::string& name, double angle, double from, double to) {
    const double n = between(random, 6, 12), sine = std::sin(angle) * from / to;
    const rt::Frame frame = rt::frame_about(direction(random));
    const vec3 normal = frame.z;
    const vec3 d = std::sin(angle) * frame.x - std::cos(angle) * normal,
               axis = sine * frame.x - std::sqrt(1 - sine * sine) * normal;
    const auto inputs = with_repeats(rows_over_square(32, [=](rt::vec2 u) { return row(d, normal, from, to, n, u); }));
    // where the wrong refraction is total, nothing passes
    const double weight = (n + 2) / (n + 1), swapped = std::sin(angle) * to / from;
    const vec3 wrong_axis = swapped < 1 ? swapped * frame.x - std::sqrt(1 - swapped * swapped) * normal : -normal;
    return probe_check(
        name, inputs,
        lobe_statistics(
            {.axis = axis,
             .outward = -normal,
             .exponent = n,
             .lobe_about = "the refracted direction",
             .suspects = {lobe_about("the lobe is about the direction of travel; expected about the refracted "
                                     "direction",
                                     d, -normal, n, weight),
                          lobe_about("the two indices of refraction are swapped", wrong_axis, -normal, n,
                                     swapped < 1 ? weight : 0),
                          lobe_about("the lobe is about the normal; expected about the refracted direction", -normal,
                                     -normal, n, weight)}}));
}

Check total_reflection(double low, double high) {
    const auto inputs = rows_of(64, [=](Generator& draw) {
        const vec3 normal = direction(draw);
        const vec3 d = -tilted(draw, normal, between(draw, std::asin(low / high) + 0.05, 1.5));
        return row(d, normal, high, low, between(draw, 5, 50), square(draw));
    });
    return probe_check(
        "total_reflection", inputs,
        {property({.id = "F3",
                   .what = "weight at total internal reflection",
                   .violation = of_call<rt::translucency>([](const rt::Scattered& s) { return rt::largest(s.weight); }),
                   .says = "at total internal reflection nothing passes: the weight is 0"})});
}

/// Any angle and exponent, into the denser, into the thinner and into what is as dense.
Check density_of_transmitted() {
    const auto row_with = [](Generator& draw, rt::vec2 u) {
        const double from = chance(draw, 0.5) ? 1.5 : 1, to = chance(draw, 0.3) ? from : 2.5 - from;
        const vec3 n = scene_direction(draw), d = -tilted(draw, n, between(draw, 0, from > to ? 0.5 : 1));
        return row(d, n, from, to, log_between(draw, 0.1, 30), u);
    };
    return density_of_lobe(row_with, [](const Row& in) {
        const auto [d, n, from, to, exponent, u] = TypesOf<decltype(&rt::translucency)>::arguments(in);
        const vec3 along = from / to * (d - rt::dot(d, n) * n);
        return LobeOf{along - std::sqrt(1 - rt::dot(along, along)) * n, -n, exponent};
    });
}

}  // namespace

Checks check_translucency(Generator& random) {
    const double low = between(random, 1, 1.1), high = between(random, 1.35, 1.8);
    // into the thinner so flat that a tenth of the lobe does not cross
    const double into_denser = between(random, 1.3, 1.45),
                 into_thinner = std::asin(std::sin(between(random, 1.3, 1.4)) * low / high);
    const Checks any_exponent = lobe_of_any_exponent(false, [](vec3 d, vec3 n, double exponent, rt::vec2 u) {
        return row(d, n, 1.0, u.y < 0.1 ? 1.0 : 1.5, exponent, u);
    });
    return joined(any_exponent,
                  {refracted_rays(random, "head_on", 0, low, high),
                   refracted_rays(random, "into_the_denser", into_denser, low, high),
                   refracted_rays(random, "into_the_thinner", into_thinner, high, low), total_reflection(low, high),
                   density_of_transmitted(), sky(random), lamp_behind(random)});
}

}  // namespace grade
