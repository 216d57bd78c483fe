#pragma once

#include "checks/kit/warp.h"

/// What reflected and transmitted lobes have in common: BRDF (n + 2)/2pi cos^n about an axis, times the cosine at the
/// surface. Any density is right whose weight is BRDF x cosine / density, so only weighted means are judged.
namespace grade {

/// A lobe that a mistake is known to give. A fragment may use its random numbers as it likes, so lobes are told by
/// their means: the share of the light, where it goes, and how broadly.
struct LobeSuspect {
    std::string words;
    std::function<rt::Scattered(rt::vec2 u)> sample;
};

/// A lobe about the given axis with the weight of the right one.
LobeSuspect lobe_about(std::string words, rt::vec3 axis, rt::vec3 outward, double exponent, double weight);

/// The experiment: one ray, one surface, fixed; u varies.
struct LobeSetting {
    rt::vec3 axis;     // of the lobe: mirror or refracted direction
    rt::vec3 outward;  // the normal on the side to which the lobe goes
    double exponent;
    std::string lobe_about;  // "the mirror direction"
    std::vector<LobeSuspect> suspects;
};

/// Where the lobe of a call lies.
struct LobeOf {
    rt::vec3 axis, outward;
    double exponent;
};

/// Whether directions have the density that their weight supposes, BRDF x cosine / weight.
Check density_of_lobe(const RowWith& row_with, std::function<LobeOf(const Row& inputs)> lobe_of);

std::vector<Statistic> lobe_statistics(const LobeSetting& setting);

/// Exponents 0 and from 0.1 to 10,000, head on along an axis of the world: the width of the lobe.
///
/// row_with(d, n, exponent, u)  the fragment's arguments; the lobe is about d, or about n
Checks lobe_of_any_exponent(bool reflected, Row (*row_with)(rt::vec3 d, rt::vec3 n, double exponent, rt::vec2 u));

}  // namespace grade
