#include <fmt/format.h>

#include "checks/fragment_checks.h"
#include "checks/kit/draw.h"
#include "checks/kit/formula.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
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

double cosine(const Row& in, const Row& out) {
    return rt::dot(from_row<DirectionSample>(out).direction, argument<0, vec3, double, vec2>(in));
}

/// The returned density against a function of the returned direction's cosine and of g.
double density_error(const Row& in, const Row& out, double (*expected)(double, double)) {
    const double due = expected(cosine(in, out), argument<1, vec3, double, vec2>(in));
    return std::abs(from_row<DirectionSample>(out).density / due - 1);
}

Statistic density() {
    struct Mistake {
        const char* words;
        double (*density)(double c, double g);
    };
    static constexpr Mistake mistakes[] = {
        {"is 4 pi times too large: expected the density per solid angle",
         [](double c, double g) { return 4 * rt::pi * phase(c, g); }},
        {"is 2 pi times too large: expected the density per solid angle, not that of the cosine",
         [](double c, double g) { return 2 * rt::pi * phase(c, g); }},
        {"has g with the wrong sign", [](double c, double g) { return phase(-c, g); }},
        {"is that of isotropic scattering, 1/(4 pi)", [](double, double) { return 1 / (4 * rt::pi); }},
        {"lacks the factor 1 - g^2", [](double c, double g) { return phase(c, g) / (1 - g * g); }},
        {"has the exponent 1/2; expected 3/2",
         [](double c, double g) { return phase(c, g) * (1 + g * g - 2 * g * c); }},
        {"has the exponent 1; expected 3/2",
         [](double c, double g) { return phase(c, g) * std::sqrt(1 + g * g - 2 * g * c); }}};
    Statistic s = property("V3", "returned density over that of the returned direction, off 1 by",
                           [](const Row& in, const Row& out) { return density_error(in, out, phase); }, 1e-3,
                           "the density is not that of the returned direction");
    s.cause = [](const Observation& seen) -> std::string {
        for (const Mistake& mistake : mistakes) {
            bool all = true;
            for (std::size_t k = 0; all && k < seen.inputs.size(); ++k)
                all = density_error(seen.inputs[k], seen.outputs[k], mistake.density) < 1e-3;
            if (all) return fmt::format("the density {}", mistake.words);
        }
        return "";
    };
    return s;
}

Statistic length_of_direction() {
    return property(
        "V3", "length of the direction, off 1 by",
        [](const Row&, const Row& out) { return std::abs(glm::length(from_row<DirectionSample>(out).direction) - 1); },
        1e-4, "the direction is no unit vector");
}

Check directions(const std::string& name, double g) {
    const auto inputs = rows_of(1024, [=](Generator& random) {
        const vec3 d = direction(random);
        return row(d, g, square(random));
    });
    Statistic mean =
        mean_of("B1", "mean cosine of the scattering angle", cosine, g, 1,
                by_value("the mean cosine of the scattering angle",
                         {{-g, "is it measured from d, the direction of travel, or from where the light came from?"},
                          {0, "is g used, and is the direction turned from its own frame into that about d?"}},
                         0.05));
    Statistic spread = uniform_in_square(
        "V3", "chi squared of the directions per degree of freedom",
        [=](const Row& in, const Row& out) {
            const vec3 d = argument<0, vec3, double, vec2>(in), w = from_row<DirectionSample>(out).direction;
            const rt::Frame frame = rt::frame_about(d);
            const double turn = std::atan2(rt::dot(w, frame.y), rt::dot(w, frame.x)) / (2 * rt::pi);
            return vec2(cosine_distribution(rt::dot(w, d), g), turn < 0 ? turn + 1 : turn);
        },
        8, 8,
        always("the directions are not spread as the phase function says: the cosine depends on one coordinate of u, "
               "the angle about d on the other"));
    return probe_check(name, inputs, {mean, spread, density(), length_of_direction()});
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
    const View view{place({0, 0, 1.5}), place({0, 0, 0}), place.turned({0, 1, 0}), 4, {24, 24}};
    const std::string scene =
        toml(view) +
        fmt::format(
            "[materials.mist]\ntransmittance = 1\nmedium = {{ extinction = {}, albedo = [{}, {}, 0], g = {} }}\n\n",
            toml(extinction), albedo, albedo, toml(g)) +
        "[materials.ahead]\nemission = [1, 0, 1]\nsampled = false\n\n[materials.behind]\nemission = [0, 1, 0]\nsampled "
        "= false\n\n" +
        sphere("mist", place({0, 0, 0}), 1) + disc("ahead", place({0, 0, -1.1}), place.turned({0, 0, 1}), 1000) +
        disc("behind", place({0, 0, 1.6}), place.turned({0, 0, -1}), 1000);

    const auto parts = [](const rt::Image& image) {
        const rt::Color mean = region_mean(image, whole(image));
        return vec2((mean.r - mean.b) / albedo, mean.g / albedo);
    };
    const double all = scattered_once(extinction, g, 1) + scattered_once(extinction, g, -1);
    Statistic share = of_picture(
        "B1", "share of the scattered light that goes on ahead",
        [=](const rt::Image& image) { return parts(image).x / (parts(image).x + parts(image).y); },
        share_ahead(extinction, g), 0.04,
        by_value("the share of the scattered light that goes on ahead",
                 {{share_ahead(extinction, -g), "is g taken with the wrong sign, or from where the light came from?"},
                  {share_ahead(extinction, 0), "is g used?"}},
                 0.04));
    Statistic sum = of_picture(
        "B1", "light scattered once, over what must be",
        [=](const rt::Image& image) { return (parts(image).x + parts(image).y) / all; }, 1, 0.06,
        by_ratio("the light that is scattered once", {{4 * rt::pi, "is the density 4 pi times too small?"},
                                                      {1 / (4 * rt::pi), "is the density 4 pi times too large?"}}));
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
    return {directions("forward", forward), directions("backward", backward),
            probe_check("any_g", extremes, {length_of_direction(), density()}), white_medium(random), ahead_and_behind(random)};
}

}  // namespace grade
