#pragma once

#include "checks/kit/scene.h"

/// Pictures of glass, of which refraction, Fresnel's share and the rays that leave a hit are asked.
namespace grade {

/// A bright quad on the floor, under a slab of glass that the camera looks through at an angle. The slab moves the quad
/// (F4), and lets through (1 - F)^2 of its light: nothing is mirrored, as its reflectance is 0.
Check slab(Generator& random, const std::string& name);

/// A ball of glass and a bubble of air in glass, where light comes from everywhere alike: neither can be seen (F3).
/// Beyond a part of its radius the bubble reflects all light.
Check invisible_glass(Generator& random);

}  // namespace grade
