#pragma once

#include <string>

#include "rt/batch.h"
#include "rt/world.h"

/// What raytrace --pixel prints: the values of each lane of a batch, in words.
namespace rt {

/// The rays of a wave and what they met.
std::string describe_wave(const World& world, int wave, const Batch& batch, const Surfaces& surfaces);

/// The radiance that each lane's sample has gathered so far.
std::string describe_light(const Batch& batch, const Chunk& chunk);

}  // namespace rt
