#pragma once

#include "checks/kit/scene.h"
#include "statistics/region.h"

/// Pictures that several fragments are asked for, or that need much text.
namespace grade {

/// A bright quad on the floor, under a slab of glass that the camera looks through at an angle. The slab moves the quad
/// (F4), and lets through (1 - F)^2 of its light: nothing is mirrored, as its reflectance is 0.
Check slab(Generator& random, const std::string& name);

/// A ball of glass and a bubble of air in glass, where light comes from everywhere alike: neither can be seen (F3).
/// Beyond a part of its radius the bubble reflects all light.
Check invisible_glass(Generator& random);

/// The material of a medium behind a surface that does not bend light.
std::string milk(const std::string& name, double extinction, rt::vec3 albedo, double g);

/// A ball of medium where light comes from everywhere alike, seen from so far that its rays are parallel. Red is not
/// absorbed and cannot be seen. Of green and blue, albedos 1 - e and 1 - 2e, a little is lost at each scattering: from
///
///     1 - E (1 - e)^N = e E N - e^2 E N (N - 1)/2 + ...
///
/// for both of them follows E N, the mean number of scatterings.
Check white_medium(Generator& random);

/// G1: whether pixels share random numbers. `what` is drawn, "position in the pixel", or is always `otherwise`, "the
/// middle", which looks the same.
Statistic own_numbers(const Region& region, int samples, const std::string& what, const std::string& otherwise);

}  // namespace grade
