#pragma once

#include <cmath>

namespace grade {

/// Radiance inside a closed box of which every wall emits `emission` and reflects `albedo` diffusely, after the given
/// number of bounces:
///
///     emission (1 - albedo^(bounces + 1)) / (1 - albedo)
inline double furnace_radiance(double emission, double albedo, int bounces) {
    return albedo == 1 ? emission * (bounces + 1) : emission * (1 - std::pow(albedo, bounces + 1)) / (1 - albedo);
}

}  // namespace grade
