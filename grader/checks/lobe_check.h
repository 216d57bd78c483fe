#pragma once

#include <fmt/format.h>

#include "checks/probe_check.h"
#include "checks/warp.h"
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
    Statistic albedo = mean_of("P2", "reflected or transmitted share", weighted([](rt::vec3) { return 1.0; }), all, all,
        by_ratio("the mean weight", {{(n + 1) / (n + 2), "n + 1 stands for n + 2 in the BRDF"}, {1 / all, "is the weight always 1? expected BRDF x cosine / density"},
                                     {(n + 2) / (n + 1), "(n + 2)/(n + 1) counts twice"}, {rt::pi, "is 1/pi missing?"}, {2, "is 2 pi taken for pi?"}},
                 "expected (n + 2)/(2 pi) cos(alpha)^n x cosine at the surface / density"));
    const double plain = width / all;
    Statistic spread = mean_of("P1", "width of the lobe: mean weight of 1 - cos(alpha), over its value",
        weighted([=](rt::vec3 d) { return (1 - rt::dot(d, setting.axis)) / width; }), 1, 1,
        [=](double value, double) {
            if (value < 0.02) return std::string("all rays run along the axis of the lobe: it is a perfect mirror, or clear glass");
            const double at_most = value * plain;  // 1/(n' + 3) at normal incidence
            return fmt::format("the lobe is {:.3g} times as wide as it must be, as if its exponent were about {:.3g} in place of {:.3g}: is it about {}, "
                               "with the exponent n, and the cosine at the surface once in its weight?",
                               value, 1 / at_most - 3, n, setting.lobe_about);
        });
    const rt::Frame frame = rt::frame_about(setting.axis);
    const rt::vec3 across = angle > 0.05 ? rt::unit(rt::cross(setting.outward, setting.axis)) : frame.x;
    Statistic sideways = mean_of("P1", "mean weight of the direction, sideways", weighted([=](rt::vec3 d) { return rt::dot(d, across); }), 0, std::sqrt(width),
        always("the lobe leans to one side: do its angle and its turn each use a number of their own?"));
    std::vector<Statistic> statistics = {side, length, grey, albedo, spread, sideways};
    if (angle <= 0.05)
        statistics.push_back(mean_of("P1", "mean weight of the direction, upwards", weighted([=](rt::vec3 d) { return rt::dot(d, frame.y); }), 0, std::sqrt(width),
            always("the lobe leans to one side: do its angle and its turn each use a number of their own?")));
    statistics.push_back(purity());
    return statistics;
}

}  // namespace grade
