#include "asked/scatter_direction.h"
#include "checks/kit/warp.h"
#include "checks/kit/white_medium.h"

namespace grade {

namespace {

using rt::DirectionSample, rt::vec2, rt::vec3;

double phase(double c, double g) { return (1 - g * g) / (4 * rt::pi * std::pow(1 + g * g - 2 * g * c, 1.5)); }

/// P(cosine <= c).
double cosine_distribution(double c, double g) {
    if (std::abs(g) < 1e-6) return (1 + c) / 2;
    return (1 - g * g) / (2 * g) * (1 / std::sqrt(1 + g * g - 2 * g * c) - 1 / (1 + g));
}

/// The returned density against a function of the returned direction's cosine and of g.
template <class Density>
RowNumber density_error(Density expected) {
    return of_call<rt::scatter_direction>([=](const DirectionSample& s, vec3 d, double g, vec2) {
        return std::abs(s.density / expected(rt::dot(s.direction, d), g) - 1);
    });
}

Statistic density() {
    return property(
        {.id = "V3",
         .what = "returned density over that of the returned direction, off 1 by",
         .violation = density_error(phase),
         .tolerance = 1e-3,
         .says = "the density is not that of the returned direction",
         .mistakes = {
             {"the density is 4 pi times too large: expected the density per solid angle",
              density_error([](double c, double g) { return 4 * rt::pi * phase(c, g); })},
             {"the density is 2 pi times too large: expected the density per solid angle, not that of the cosine",
              density_error([](double c, double g) { return 2 * rt::pi * phase(c, g); })},
             {"the density has g with the wrong sign", density_error([](double c, double g) { return phase(-c, g); })},
             {"the density is that of isotropic scattering, 1/(4 pi)",
              density_error([](double, double) { return 1 / (4 * rt::pi); })},
             {"the density lacks the factor 1 - g^2",
              density_error([](double c, double g) { return phase(c, g) / (1 - g * g); })},
             {"the density has the exponent 1/2; expected 3/2",
              density_error([](double c, double g) { return phase(c, g) * (1 + g * g - 2 * g * c); })},
             {"the density has the exponent 1; expected 3/2",
              density_error([](double c, double g) { return phase(c, g) * std::sqrt(1 + g * g - 2 * g * c); })}}});
}

Check directions(const std::string& name, double g) {
    const auto inputs = rows_of(1024, [=](Generator& random) {
        const vec3 d = scene_direction(random);
        return row(d, g, square(random));
    });
    const Statistic mean = mean_of(
        {.id = "B1",
         .what = "mean cosine of the scattering angle",
         .number = of_call<rt::scatter_direction>(
             [](const DirectionSample& s, vec3 d, double, vec2) { return rt::dot(s.direction, d); }),
         .truth = g,
         .unit = 1,
         .hint = by_value("the mean cosine of the scattering angle",
                          {{-g, "is it measured from d, the direction of travel, or from where the light came from?"},
                           {0, "is g used, and is the direction turned from its own frame into that about d?"}},
                          0.05)});
    const Statistic spread = uniform_in_square(
        {.id = "V3",
         .what = "chi squared of the directions per degree of freedom",
         .point = of_call<rt::scatter_direction>([=](const DirectionSample& s, vec3 d, double, vec2) {
             const rt::Frame frame = rt::frame_about(d);
             const vec3 w = s.direction;
             return vec2(cosine_distribution(rt::dot(w, d), g), turn(rt::dot(w, frame.x), rt::dot(w, frame.y)));
         }),
         .hint = always("the directions are not spread as the phase function says: the cosine depends on one "
                        "coordinate of u, the angle about d on the other")});
    return probe_check(name, inputs, {mean, spread, density(), unit_direction<rt::scatter_direction>("V3")});
}

/// Light scattered once into the half space ahead (sign 1) or behind (sign -1) on the way through the middle of a ball
/// of medium, without its albedo; R = 1:
///
///     integral of s exp(-s t) over t, of 2 pi phase(c) exp(-s r(t, c)) over the c of that sign,
///
/// r the way from there out of the ball.
double scattered_once(double extinction, double g, double sign) {
    constexpr int steps = 200;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const double t = 2 * (i + 0.5) / steps, z = t - 1, c = sign * (k + 0.5) / steps;
            const double out = -z * c + std::sqrt(1 - z * z * (1 - c * c));
            sum += extinction * std::exp(-extinction * (t + out)) * 2 * rt::pi * phase(c, g);
        }
    return sum * 2 / steps / steps;
}

double share_ahead(double extinction, double g) {
    const double ahead = scattered_once(extinction, g, 1);
    return ahead / (ahead + scattered_once(extinction, g, -1));
}

/// A thin ball of medium between two large lamps, one ahead and one behind the camera. The medium's albedo is so small
/// that only what was scattered once is seen; blue is not scattered at all, and is taken from red.
Check ahead_and_behind(Generator& random) {
    const Place place = any_place(random);
    const double g = (chance(random, 0.5) ? 1 : -1) * between(random, 0.3, 0.5), extinction = between(random, 0.4, 0.7);
    constexpr double albedo = 0.002;
    const std::string scene =
        toml(place.from_above(1.5, 4, {24, 24})) + milk("mist", extinction, {albedo, albedo, 0}, g) +
        unsampled_lamp("ahead", vec3(1, 0, 1)) + unsampled_lamp("behind", vec3(0, 1, 0)) +
        sphere("mist", place({0, 0, 0}), 1) + disc("ahead", place({0, 0, -1.1}), place.turned({0, 0, 1}), 1000) +
        disc("behind", place({0, 0, 1.6}), place.turned({0, 0, -1}), 1000);

    const auto parts = [](const rt::Image& image) {
        const rt::Color mean = region_mean(image, whole(image));
        return vec2((mean.r - mean.b) / albedo, mean.g / albedo);
    };
    const double all = scattered_once(extinction, g, 1) + scattered_once(extinction, g, -1);
    const Statistic share = of_picture(
        {.id = "B1",
         .what = "share of the scattered light that goes on ahead",
         .number = [=](const rt::Image& image) { return parts(image).x / (parts(image).x + parts(image).y); },
         .truth = share_ahead(extinction, g),
         .delta = 0.04,
         .hint = by_value(
             "the share of the scattered light that goes on ahead",
             {{share_ahead(extinction, -g), "is g taken with the wrong sign, or from where the light came from?"},
              {share_ahead(extinction, 0), "is g used?"}},
             0.04)});
    const Statistic sum =
        of_picture({.id = "B1",
                    .what = "light scattered once, over what must be",
                    .number = [=](const rt::Image& image) { return (parts(image).x + parts(image).y) / all; },
                    .delta = 0.06,
                    .hint = by_ratio("the light that is scattered once",
                                     {{4 * rt::pi, "is the density 4 pi times too small?"},
                                      {1 / (4 * rt::pi), "is the density 4 pi times too large?"}})});
    return render_check("ahead_and_behind", {scene, 16, "sobol"}, {share, sum});
}

}  // namespace

Checks check_scatter_direction(Generator& random) {
    const double forward = between(random, 0.35, 0.8), backward = between(random, -0.8, -0.35);
    // all directions alike, and the narrowest lobes that are asked for
    const auto extremes = rows_of(64, [](Generator& draw) {
        const double values[] = {0, 1e-3, -1e-3, 0.98, -0.98};
        const vec3 d = direction(draw);
        const double g = values[whole_between(draw, 0, 4)];
        return row(d, g, square(draw));
    });
    const auto row_with = [](Generator& draw, vec2 u) {
        const vec3 d = exact_direction(draw);
        const double g = between(draw, -0.9, 0.9);
        return row(d, g, u);
    };
    // as often where the formulas are not far from 0/0
    const auto any_g = [](Generator& draw, vec2 u) {
        const vec3 d = exact_direction(draw);
        const double small = log_between(draw, 2e-3, 0.2), any = between(draw, -0.9, 0.9);
        return row(d, chance(draw, 0.5) ? any : std::copysign(small, any), u);
    };
    Check axes = axes_of_the_world(row_with);
    axes.statistics.push_back(
        mean_of({.id = "B1",
                 .what = "mean of cosine less g, about the axes of the world",
                 .number = of_call<rt::scatter_direction>(
                     [](const DirectionSample& s, vec3 d, double g, vec2) { return rt::dot(s.direction, d) - g; }),
                 .truth = 0,
                 .unit = 1,
                 .hint = always("about an axis of the world, directions are not those about "
                                "others")}));
    return {directions("forward", forward),
            directions("backward", backward),
            directions("isotropic", 0),
            probe_check("any_g", extremes, {unit_direction<rt::scatter_direction>("V3"), density()}),
            density_of_directions<rt::scatter_direction>({any_g}),
            ends_of_square(row_with),
            axes,
            white_medium(random),
            ahead_and_behind(random)};
}

}  // namespace grade
