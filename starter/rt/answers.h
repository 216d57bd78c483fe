#pragma once

#include <functional>
#include <span>

#include "rt/parts.h"
#include "rt/ray.h"

/// What fragments take and return, beside rays and the parts of a scene.
namespace rt {

using Function = std::function<Real(Real)>;

/// An interval of the integration domain, and the random numbers in [0, 1) that are to be used in it.
struct Stratum {
    Real low, high;
    std::span<const Real> u;
};

/// The weights of what leaves a surface towards the viewer [1].
struct Outgoing {
    Color local;   // light that this surface scatters itself
    Color mirror;  // what arrives from the mirror direction
    Color glass;   // what arrives from the refracted direction
};

struct DiskSample {
    vec2 point;
    Real density;  // [1/m2] on the unit disk
};

struct DirectionSample {
    vec3 direction;  // unit
    Real density;    // [1/sr]
};

struct FilmSample {
    vec2 position;  // [pixel]
    Real weight;    // of its radiance in the pixel's mean
};

struct LightSample {
    vec3 direction;  // unit, from the surface towards the light [world]
    Real distance;   // [m]
    Real density;    // [1/sr]; 0: the light does not shine here
};

struct Scattered {
    vec3 direction;  // unit [world]
    Color weight;    // BRDF x cosine / density; 0: nothing goes that way
};

/// What the previous vertex of a path was.
enum class Event { camera, diffuse, specular, lobe, medium };

}  // namespace rt
