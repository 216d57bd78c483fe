#pragma once

#include "rt/stages/stages.h"

namespace rt {

/// What the lanes' materials reflect: black where there is no surface.
struct Reflectances {
    Colors albedo, specular;
    Real shininess[lanes];  // specular and shininess: where there are highlights
};

/// What glossy lobes reflect to the viewer; black where there is none.
struct Lobes {
    Colors mirror;
    Real exponent[lanes];
};

/// What each lane's material reflects; black where there is no surface. Returns whether any lane reflects.
bool look_up_reflectances(const World& world, int count, const Surfaces& s, Reflectances& r);

/// The lobes of the lanes whose rays go on, where lamps are weighed against them. Returns whether there is any.
bool look_up_lobes(const World& world, const Batch& b, const Surfaces& s, Lobes& lobes);

}  // namespace rt
