#pragma once

#include "checks/check.h"

/// Pictures of one bright figure, for the fragments of Whitted's part.
namespace grade {

Check slanted_quad(Generator& random);     // camera_ray
Check silhouette(Generator& random);       // hit_sphere
Check two_triangles(Generator& random);    // hit_triangle
Check mirror_image(Generator& random);     // mirror_direction
Check through_a_slab(Generator& random);   // refracted_direction
Check bright_slab(Generator& random);      // fresnel_dielectric
Check invisible_glass(Generator& random);  // whitted

}  // namespace grade
