#include "checks/kit/lobe_check.h"

#include "statistics/closed_forms.h"
#include "statistics/moments.h"

namespace grade {

using rt::Scattered;

namespace {

/// A direction of the lobe cos^exponent about an axis.
rt::vec3 lobe_direction(rt::vec3 axis, double exponent, rt::vec2 u) {
    const double cosine = std::pow(1 - u.x, 1 / (exponent + 1)), sine = rt::safe_sqrt(1 - cosine * cosine);
    const rt::vec2 circle = rt::unit_circle(u.y);
    return rt::frame_about(axis).to_world({sine * circle.x, sine * circle.y, cosine});
}

/// Mistakes of exponent and of what is below the surface.
std::vector<LobeSuspect> common_lobe_suspects(rt::vec3 axis, rt::vec3 outward, double n) {
    const double weight = (n + 2) / (n + 1);
    std::vector<LobeSuspect> suspects;
    for (const auto& [words, wrong] :
         {std::pair("2n", 2 * n), std::pair("n + 1", n + 1), std::pair("n - 1", n - 1), std::pair("n/2", n / 2)})
        for (const double factor : {weight, (wrong + 2) / (wrong + 1)})
            suspects.push_back(lobe_about(fmt::format("the exponent of the lobe is {}; expected n", words), axis,
                                          outward, wrong, factor));
    suspects.push_back(
        {"what goes below the surface is mirrored up; its weight must be 0", [=](rt::vec2 u) {
             const rt::vec3 d = lobe_direction(axis, n, u);
             const double cosine = rt::dot(d, outward);
             return Scattered{cosine < 0 ? d - 2 * cosine * outward : d, rt::Color(weight * std::abs(cosine))};
         }});
    return suspects;
}

/// Mean weight, mean weighted direction and width, each with its standard error.
std::array<Moments, 5> lobe_means(const std::vector<rt::Scattered>& rays, rt::vec3 axis) {
    std::array<Moments, 5> means;
    for (const rt::Scattered& s : rays) {
        const double w = s.weight.x;
        const rt::vec3 d = w != 0 ? s.direction : rt::vec3(0);
        const double numbers[] = {w, w * d.x, w * d.y, w * d.z, w * rt::sqr(rt::dot(d, axis))};
        for (std::size_t k = 0; k < means.size(); ++k) means[k].add(numbers[k]);
    }
    return means;
}

/// The words of the suspect whose means are closest to those of the outputs, if they may be the same; empty: none.
std::string lobe_cause(const Observation& seen, rt::vec3 axis, const std::vector<LobeSuspect>& suspects) {
    std::vector<rt::Scattered> theirs;
    for (const Row& out : seen.outputs) theirs.push_back(from_row<rt::Scattered>(out));
    const auto given = lobe_means(theirs, axis);
    std::string words;
    double least = 3.5;  // standard errors of the worst mean
    for (const LobeSuspect& suspect : suspects) {
        constexpr int side = 64;
        std::vector<rt::Scattered> rays;
        for (int i = 0; i < side * side; ++i)
            rays.push_back(suspect.sample({(i % side + 0.5) / side, (i / side + 0.5) / side}));
        const auto expected = lobe_means(rays, axis);
        double worst = 0;
        for (std::size_t k = 0; k < given.size(); ++k)
            worst = std::max(worst, std::abs(given[k].mean - expected[k].mean) / (given[k].standard_error() + 3e-4));
        if (worst < least) least = worst, words = suspect.words;
    }
    return words;
}

/// What a ray of the lobe adds to a mean.
RowNumber weighted(std::function<double(rt::vec3)> f) {
    return of_result<Scattered>(
        [f](const Scattered& s) { return s.weight.x != 0 ? s.weight.x * f(s.direction) : 0.0; });
}

/// What holds for each ray by itself.
std::vector<Statistic> ray_properties_of_lobe(rt::vec3 outward) {
    return {property({.id = "P3",
                      .what = "weight of rays to the wrong side of the surface",
                      .violation = of_result<Scattered>([outward](const Scattered& s) {
                          return rt::dot(s.direction, outward) < -1e-9 ? rt::largest(s.weight) : 0.0;
                      }),
                      .says = "a ray of the lobe that goes to the wrong side of the surface must have weight 0"}),
            property({.id = "P1",
                      .what = "length of the direction, off 1 by",
                      .violation = of_result<Scattered>([](const Scattered& s) {
                          return s.weight == rt::Color(0) ? 0.0 : std::abs(glm::length(s.direction) - 1);
                      }),
                      .tolerance = 1e-4,
                      .says = "the direction is no unit vector"}),
            property({.id = "P1",
                      .what = "difference of the weight's channels",
                      .violation = of_result<Scattered>(
                          [](const Scattered& s) { return rt::largest(s.weight - rt::Color(s.weight.x)); }),
                      .tolerance = 1e-6,
                      .says = "the weight has no colour: the framework adds that of the material"})};
}

/// all  the share of the light that the lobe takes; at the angle whose cosine is given
Statistic mean_weight(const LobeSetting& setting, double all, double angle) {
    const double n = setting.exponent;
    // without the light below the surface, |cosine| in place of max(0, cosine) adds as much as the signed cosine lacks
    const double below = all - std::cos(angle);
    return find_half_a_percent(mean_of(
        {.id = "P2",
         .what = "reflected or transmitted share",
         .number = weighted([](rt::vec3) { return 1.0; }),
         .truth = all,
         .hint = by_value(
             "the mean weight",
             {{all * (n + 1) / (n + 2), "n + 1 stands for n + 2 in the BRDF"},
              {1, "is the weight always 1? Expected BRDF x cosine / density"},
              {all * (n + 2) / (n + 1), "is the cosine at the surface missing, or does (n + 2)/(n + 1) count twice?"},
              {0, fmt::format("no ray of the lobe counts: is it about {}, on the right side of the surface? Or are "
                              "indices of refraction exchanged?",
                              setting.lobe_about)},
              {all + below, "are rays below the surface mirrored up, or kept? Their weight is 0"},
              {all * rt::pi, "is 1/pi missing?"},
              {all * 2, "is 2 pi taken for pi?"}},
             0.04 * all, "expected (n + 2)/(2 pi) cos(alpha)^n x cosine at the surface / density")}));
}

/// The width of the lobe, however bright it is; due: the mean of 1 - cos(alpha).
Statistic width_of_lobe(const LobeSetting& setting, double due) {
    Statistic s = mean_of({.id = "P1", .what = "width of the lobe: weighted mean of 1 - cos(alpha), over its value"});
    s.measure = [due, axis = setting.axis](const Observation& seen) {
        double sum = 0, light = 0;
        for (const Row& out : seen.outputs) {
            const Scattered s = from_row<Scattered>(out);
            if (s.weight.x == 0) continue;
            light += s.weight.x;
            sum += s.weight.x * (1 - rt::dot(s.direction, axis));
        }
        return light == 0 ? 1 : sum / light / due;  // nothing to be seen: the mean weight says so
    };
    s.hint = [n = setting.exponent, about = setting.lobe_about](double value, double) {
        if (value < 0.02)
            return std::string("all rays run along the axis of the lobe: it is a perfect mirror, or clear glass");
        if (value > 2)
            return fmt::format(
                "the lobe is {:.3g} times as wide as it must be: is it about {}, and not about the normal?", value,
                about);
        return fmt::format(
            "the lobe is {:.3g} times as wide as it must be, as if its exponent were about {:.3g} in place of {:.3g}: "
            "is it about {}, with the exponent n, and the cosine at the surface once in its weight?",
            value, (n + 3) / value - 3, n, about);
    };
    return s;
}

}  // namespace

/// A lobe about the given axis with the weight of the right one.
LobeSuspect lobe_about(std::string words, rt::vec3 axis, rt::vec3 outward, double exponent, double weight) {
    return {std::move(words), [=](rt::vec2 u) {
                const rt::vec3 direction = lobe_direction(axis, exponent, u);
                return rt::Scattered{direction, rt::Color(std::max(0.0, weight * rt::dot(direction, outward)))};
            }};
}

std::vector<Statistic> lobe_statistics(const LobeSetting& setting) {
    const double n = setting.exponent, angle = std::acos(std::min(1.0, rt::dot(setting.axis, setting.outward)));
    const double all = phong_moment(n, angle, 0), width = all - phong_moment(n, angle, 1);
    Statistic albedo = mean_weight(setting, all, angle), spread = width_of_lobe(setting, width / all);
    const auto suspects = joined(setting.suspects, common_lobe_suspects(setting.axis, setting.outward, n));
    albedo.cause = spread.cause = [suspects, axis = setting.axis](const Observation& seen) {
        return lobe_cause(seen, axis, suspects);
    };

    const rt::Frame frame = rt::frame_about(setting.axis);
    const auto lean = [&](const std::string& way, rt::vec3 axis) {
        return mean_of({.id = "P1",
                        .what = "mean weight of the direction, " + way,
                        .number = weighted([=](rt::vec3 d) { return rt::dot(d, axis); }),
                        .truth = 0,
                        .unit = std::sqrt(width),
                        .hint = always("the lobe leans to one side: do its angle and its turn each use a number of "
                                       "their own?")});
    };
    std::vector<Statistic> statistics = ray_properties_of_lobe(setting.outward);
    const bool head_on = angle <= 0.05;
    statistics.insert(
        statistics.end(),
        {spread, albedo, lean("sideways", head_on ? frame.x : rt::unit(rt::cross(setting.outward, setting.axis)))});
    if (head_on) statistics.push_back(lean("upwards", frame.y));
    statistics.push_back(purity());
    return statistics;
}

Check density_of_lobe(const RowWith& row_with, std::function<LobeOf(const Row&)> lobe_of) {
    const auto supposed = [lobe_of](const Row& in, const Row& out) {
        const Scattered s = from_row<Scattered>(out);
        const LobeOf lobe = lobe_of(in);
        const double along = rt::dot(s.direction, lobe.axis);
        return along > 0 && s.weight.x > 0 ? (lobe.exponent + 2) / (2 * rt::pi) * std::pow(along, lobe.exponent) *
                                                 rt::dot(s.direction, lobe.outward) / s.weight.x
                                           : 0;
    };
    return own_density(row_with, {of_result<Scattered>([](const Scattered& s) { return s.direction; }), supposed,
                                  "(n + 2)/(2 pi) cos(alpha)^n x cosine / weight"});
}

Checks lobe_of_any_exponent(bool reflected, Row (*row_with)(rt::vec3 d, rt::vec3 n, double exponent, rt::vec2 u)) {
    const auto inputs = [row_with](Generator& random) {
        Rows rows;
        for (int decade = -2; decade < 4; ++decade)  // the first: exactly 0
            for (const Row& u : rows_over_square(24, [](rt::vec2 u) { return row(u); })(random)) {
                const rt::vec3 n = exact_direction(random);
                const double exponent = decade < -1 ? 0 : std::pow(10, decade + between(random, 0, 1));
                rows.push_back(row_with(-n, n, exponent, {u[0], u[1]}));
            }
        return rows;
    };
    // (n + 2)/2pi cos^n x cosine, times 1 - cos, integrates to 1/(n + 3)
    const auto widened = [reflected](const Row& in, const Row& out) {
        const Scattered s = from_row<Scattered>(out);
        const rt::vec3 d(in[0], in[1], in[2]), axis = reflected ? -d : d;
        const double exponent = in[reflected ? 6 : 8];
        return s.weight.x == 0 ? 0 : s.weight.x * (1 - rt::dot(s.direction, axis)) * (exponent + 3);
    };
    const auto along_axis = [row_with](Generator& random, rt::vec2 u) {
        const rt::vec3 n = exact_direction(random);
        return row_with(-n, n, range_between(random, 1, 1e4), chance(random, 0.2) ? end_of_square(random) : u);
    };
    const auto at_a_slant = [row_with](Generator& random) {
        const rt::vec3 n = exact_direction(random);
        const double angle = between(random, 0.3, 1.2),
                     exponent = chance(random, 0.3) ? 0 : log_between(random, 1, 1e4);
        return row_with(-tilted(random, n, angle), n, exponent, seam_of_square(random));
    };
    return {
        probe_check(
            "any_exponent", inputs,
            {mean_of({.id = "P1",
                      .what = "width of lobes with exponents n from 0 to 10,000: mean of 1 - cos(alpha), times n + 3",
                      .number = widened,
                      .delta0 = 0.002,
                      .delta = 0.02,
                      .hint = by_ratio("the width of lobes with exponents from 0 to 10,000", {},
                                       "is the exponent clamped, or another one than n?")})}),
        axes_of_the_world(along_axis, rows_of(64, at_a_slant))};
}

}  // namespace grade
