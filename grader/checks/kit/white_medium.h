#pragma once

#include "checks/kit/scene.h"

/// Pictures of media, of which the way and the turn of a random walk are asked.
namespace grade {

/// The material of a medium behind a surface that does not bend light.
std::string milk(const std::string& name, double extinction, rt::vec3 albedo, double g);

/// A ball of medium where light comes from everywhere alike, seen from so far that its rays are parallel. Red is not
/// absorbed and cannot be seen. Of green and blue, albedos 1 - e and 1 - 2e, a little is lost at each scattering: from
///
///     1 - E (1 - e)^N = e E N - e^2 E N (N - 1)/2 + ...
///
/// for both of them follows E N, the mean number of scatterings.
Check white_medium(Generator& random);

}  // namespace grade
