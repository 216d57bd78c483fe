#pragma once

#include "checks/kit/kit.h"

/// Warps of the unit square: what is common to the checks of directions and densities.
namespace grade {

/// Angle about z as a share of the full turn, 0 to 1.
inline double turn(double x, double y) {
    const double t = std::atan2(y, x) / (2 * rt::pi);
    return t < 0 ? t + 1 : t;
}

/// For a statistic of evenness: says so where one half of the circle about z gets nothing.
inline Cause half_circles(RowPoint point) {
    return [point](const Observation& seen) -> std::string {
        double first = 0;
        for (std::size_t k = 0; k < seen.inputs.size(); ++k) first += point(seen.inputs[k], seen.outputs[k]).y < 0.5;
        const double share = first / double(seen.inputs.size());
        return share < 0.02 || share > 0.98
                   ? "only half of the circle is used: the angle runs through a full turn, 2 pi"
                   : "";
    };
}

/// The density that is returned must be that of the direction or point that is returned: density(sample).
template <auto fragment, class Density>
Statistic right_density(Density density, double tolerance, std::vector<KnownRatio> known) {
    Statistic s = property({.id = "V3", .what = "returned density, off by its share",
                            .violation = of_call<fragment>([density](const auto& sample) {
                                const double right = density(sample);
                                return std::abs(sample.density - right) / (right + 1e-6);
                            }),
                            .tolerance = tolerance});
    s.cause = [density, known](const Observation& seen) {
        double ratio = 0, count = 0;
        for (const Row& outputs : seen.outputs) {
            const auto sample = result<fragment>(outputs);
            const double right = density(sample);
            if (right > 1e-6) ratio += sample.density / right, ++count;
        }
        return by_ratio("the density that is returned", known, "it is not the density of the returned direction")(
            ratio / count, 1);
    };
    return s;
}

}  // namespace grade
