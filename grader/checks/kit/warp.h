#pragma once

#include "checks/kit/draw.h"
#include "checks/kit/estimate.h"
#include "checks/kit/formula.h"

/// Warps of the unit square: what is common to the checks of directions and densities.
namespace grade {

/// Angle about z as a share of the full turn, 0 to 1.
inline double turn(double x, double y) {
    const double t = std::atan2(y, x) / (2 * rt::pi);
    return t < 0 ? t + 1 : t;
}

/// For a statistic of evenness: says so where one half of the circle about z gets nothing.
inline void name_half_circles(Statistic& s, std::function<rt::vec2(const Row& inputs, const Row& outputs)> point) {
    s.cause = [point](const Observation& seen) -> std::string {
        double first = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) first += point(seen.inputs[k], seen.outputs[k]).y < 0.5;
        const double share = first / double(seen.inputs.size());
        return share < 0.02 || share > 0.98
                   ? "only half of the circle is used: the angle runs through a full turn, 2 pi"
                   : "";
    };
}

/// Directions must have length 1.
inline Statistic unit_length() {
    return property(
        "V3", "length of the direction, off 1 by",
        [](const Row&, const Row& out) {
            return std::abs(std::sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]) - 1);
        },
        1e-4, "the direction is no unit vector");
}

/// The density that is returned must be that of the direction that is returned. density(inputs, outputs)
inline Statistic right_density(std::function<double(const Row&, const Row&)> density, double tolerance,
                               std::vector<KnownRatio> known = {}) {
    Statistic s = property(
        "V3", "returned density, off by its share",
        [density](const Row& in, const Row& out) {
            const double right = density(in, out);
            return std::abs(out.back() - right) / (right + 1e-6);
        },
        tolerance, "");
    s.cause = [density, known](const Observation& seen) {
        double ratio = 0, count = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) {
            const double right = density(seen.inputs[k], seen.outputs[k]);
            if (right > 1e-6) ratio += seen.outputs[k].back() / right, ++count;
        }
        return by_ratio("the density that is returned", known, "it is not the density of the returned direction")(
            ratio / count, 1);
    };
    return s;
}

}  // namespace grade
