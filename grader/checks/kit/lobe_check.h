#pragma once

#include <fmt/format.h>

#include "checks/kit/lobe_suspects.h"
#include "checks/kit/probe_check.h"
#include "checks/kit/render_check.h"
#include "checks/kit/warp.h"
#include "statistics/lobe.h"

/// What reflected and transmitted lobes have in common: BRDF (n + 2)/2pi cos^n about an axis, times the cosine at the
/// surface. Any density is right whose weight is BRDF x cosine / density, so only weighted means are judged.
namespace grade {

/// The experiment: one ray, one surface, fixed; u varies.
struct LobeSetting {
    rt::vec3 axis;     // of the lobe: mirror or refracted direction
    rt::vec3 outward;  // the normal on the side to which the lobe goes
    double exponent;
    std::string lobe_about;  // "the mirror direction"
    std::vector<LobeSuspect> suspects;
};

inline std::vector<Statistic> lobe_statistics(const LobeSetting& setting) {
    const double n = setting.exponent, angle = std::acos(std::min(1.0, rt::dot(setting.axis, setting.outward)));
    const double all = phong_moment(n, angle, 0), width = all - phong_moment(n, angle, 1);
    const auto weighted = [](std::function<double(rt::vec3)> f) {
        return [f](const Row&, const Row& out) {
            const rt::Scattered s = from_row<rt::Scattered>(out);
            return s.weight.x != 0 ? s.weight.x * f(s.direction) : 0.0;
        };
    };
    Statistic side = property("P3", "weight of rays to the wrong side of the surface",
        [=](const Row&, const Row& out) {
            const rt::Scattered s = from_row<rt::Scattered>(out);
            return rt::dot(s.direction, setting.outward) < -1e-9 ? rt::largest(s.weight) : 0.0;
        },
        0, "a ray of the lobe that goes to the wrong side of the surface must have weight 0");
    Statistic length = property("P1", "length of the direction, off 1 by",
        [](const Row&, const Row& out) {
            const rt::Scattered s = from_row<rt::Scattered>(out);
            return s.weight == rt::Color(0) ? 0.0 : std::abs(glm::length(s.direction) - 1);
        },
        1e-4, "the direction is no unit vector");
    Statistic grey = property("P1", "difference of the weight's channels",
        [](const Row&, const Row& out) {
            const rt::Color w = from_row<rt::Scattered>(out).weight;
            return rt::largest(w - rt::Color(w.x));
        },
        1e-6, "the weight has no colour: the framework adds that of the material");
    // without the light below the surface, |cosine| in place of max(0, cosine) adds as much as the signed cosine lacks
    const double below = all - std::cos(angle);
    Statistic albedo = mean_of(
        "P2", "reflected or transmitted share", weighted([](rt::vec3) { return 1.0; }), all, all,
        by_value(
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
            0.04 * all, "expected (n + 2)/(2 pi) cos(alpha)^n x cosine at the surface / density"));
    find_half_a_percent(albedo);
    // the width of the lobe, however bright it is
    Statistic spread = mean_of(
        "P1", "width of the lobe: weighted mean of 1 - cos(alpha), over its value", nullptr, 1, 1,
        [=](double value, double) {
            if (value < 0.02)
                return std::string("all rays run along the axis of the lobe: it is a perfect mirror, or clear glass");
            if (value > 2)
                return fmt::format(
                    "the lobe is {:.3g} times as wide as it must be: is it about {}, and not about the normal?", value,
                    setting.lobe_about);
            return fmt::format(
                "the lobe is {:.3g} times as wide as it must be, as if its exponent were about {:.3g} in place of "
                "{:.3g}: is it about {}, "
                "with the exponent n, and the cosine at the surface once in its weight?",
                value, (n + 3) / value - 3, n, setting.lobe_about);
        });
    spread.measure = [=](const Observation& seen) {
        double sum = 0, light = 0;
        for (const Row& out : seen.outputs) {
            const rt::Scattered s = from_row<rt::Scattered>(out);
            if (s.weight.x == 0) continue;
            light += s.weight.x;
            sum += s.weight.x * (1 - rt::dot(s.direction, setting.axis));
        }
        return light == 0 ? 1 : sum / light / (width / all);  // nothing to be seen: the mean weight says so
    };
    auto suspects = setting.suspects;
    for (LobeSuspect& suspect : common_lobe_suspects(setting.axis, setting.outward, n))
        suspects.push_back(std::move(suspect));
    albedo.cause = spread.cause = [suspects, axis = setting.axis](const Observation& seen) {
        return lobe_cause(seen, axis, suspects);
    };
    const rt::Frame frame = rt::frame_about(setting.axis);
    const rt::vec3 across = angle > 0.05 ? rt::unit(rt::cross(setting.outward, setting.axis)) : frame.x;
    Statistic sideways =
        mean_of("P1", "mean weight of the direction, sideways",
                weighted([=](rt::vec3 d) { return rt::dot(d, across); }), 0, std::sqrt(width),
                always("the lobe leans to one side: do its angle and its turn each use a number of their own?"));
    std::vector<Statistic> statistics = {side, length, grey, spread, albedo, sideways};
    if (angle <= 0.05)
        statistics.push_back(
            mean_of("P1", "mean weight of the direction, upwards",
                    weighted([=](rt::vec3 d) { return rt::dot(d, frame.y); }), 0, std::sqrt(width),
                    always("the lobe leans to one side: do its angle and its turn each use a number of their own?")));
    statistics.push_back(purity());
    return statistics;
}

}  // namespace grade
