#pragma once

#include "checks/kit/check.h"

/// Pictures of one bright figure, and of plain surfaces: the feature that a fragment makes.
namespace grade {

Check slanted_quad(Generator& random);     // camera_ray, hit_quad
Check edge_noise(Generator& random);       // stratified_2d
Check open_sky(Generator& random);         // cosine_hemisphere
Check silhouette(Generator& random);       // hit_sphere
Check two_triangles(Generator& random);    // hit_triangle
Check mirror_image(Generator& random);     // mirror_direction
Check through_a_slab(Generator& random);   // refracted_direction
Check bright_slab(Generator& random);      // fresnel_dielectric
Check invisible_glass(Generator& random);  // whitted, fresnel_dielectric

}  // namespace grade
