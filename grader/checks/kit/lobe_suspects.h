#pragma once

#include <array>
#include <string>
#include <vector>

#include "checks/kit/probe_check.h"
#include "checks/kit/warp.h"
#include "statistics/moments.h"

/// Lobes that mistakes are known to give. A fragment may use its random numbers as it likes, so they are told by their
/// means: the share of the light, where it goes, and how broadly.
namespace grade {

struct LobeSuspect {
    std::string words;
    std::function<rt::Scattered(rt::vec2 u)> sample;
};

/// A direction of the lobe cos^exponent about an axis.
inline rt::vec3 lobe_direction(rt::vec3 axis, double exponent, rt::vec2 u) {
    const double cosine = std::pow(1 - u.x, 1 / (exponent + 1)), sine = rt::safe_sqrt(1 - cosine * cosine);
    const rt::vec2 circle = rt::unit_circle(u.y);
    return rt::frame_about(axis).to_world({sine * circle.x, sine * circle.y, cosine});
}

/// A lobe about the given axis with the weight of the right one.
inline LobeSuspect lobe_about(std::string words, rt::vec3 axis, rt::vec3 outward, double exponent, double weight) {
    return {std::move(words), [=](rt::vec2 u) {
                const rt::vec3 direction = lobe_direction(axis, exponent, u);
                return rt::Scattered{direction, rt::Color(std::max(0.0, weight * rt::dot(direction, outward)))};
            }};
}

/// Mistakes of exponent and of what is below the surface.
inline std::vector<LobeSuspect> common_lobe_suspects(rt::vec3 axis, rt::vec3 outward, double n) {
    const double weight = (n + 2) / (n + 1);
    std::vector<LobeSuspect> suspects;
    struct Exponent {
        std::string words;
        double value;
    };
    for (const Exponent& e :
         {Exponent{"2n", 2 * n}, Exponent{"n + 1", n + 1}, Exponent{"n - 1", n - 1}, Exponent{"n/2", n / 2}})
        for (const double factor : {weight, (e.value + 2) / (e.value + 1)})
            suspects.push_back(
                lobe_about("the exponent of the lobe is " + e.words + "; expected n", axis, outward, e.value, factor));
    suspects.push_back({"what goes below the surface is mirrored up; its weight must be 0", [=](rt::vec2 u) {
                            const rt::vec3 d = lobe_direction(axis, n, u);
                            const double cosine = rt::dot(d, outward);
                            return rt::Scattered{cosine < 0 ? d - 2 * cosine * outward : d,
                                                 rt::Color(weight * std::abs(cosine))};
                        }});
    return suspects;
}

/// Mean weight, mean weighted direction and width, each with its standard error.
inline std::array<Moments, 5> lobe_means(const std::vector<rt::Scattered>& rays, rt::vec3 axis) {
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
inline std::string lobe_cause(const Observation& seen, rt::vec3 axis, const std::vector<LobeSuspect>& suspects) {
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

}  // namespace grade
