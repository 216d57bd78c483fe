#pragma once

#include <vector>

#include "rt/scene.h"
#include "rt/tree/bvh.h"

/// The bodies in which light is scattered, as far as a plan must know them: how large they are. Hollows and other
/// bodies in them are left out. Nobody needs this file for the assignment.
namespace rt {

struct Body {
    const Material* material;
    Box box;
};

/// Of each sphere, each mesh, and all flat shapes of a material together.
std::vector<Body> scattering_bodies(const Scene& scene);

/// How often light that comes from everywhere alike is scattered in a body that absorbs nothing: the mean chord, four
/// times the volume over the surface, in mean free ways. The body is a box; of one about a sphere it is the sphere's.
///
/// Source: Blanco and Fournier, "An Invariance Property of Diffusive Random Walks", Europhysics Letters 61(2), 2003.
Real mean_scatterings(const Body& body);

}  // namespace rt
