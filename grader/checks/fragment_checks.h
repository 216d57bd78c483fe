#pragma once

#include "checks/kit/check.h"

/// The checks of each fragment, in files of their own. The generator draws their parameters.
namespace grade {

using Checks = std::vector<Check>;

Checks check_integrate_uniform(Generator& random);
Checks check_integrate_monte_carlo(Generator& random);
Checks check_integrate_stratified(Generator& random);

Checks check_camera_ray(Generator& random);
Checks check_hit_sphere(Generator& random);
Checks check_hit_triangle(Generator& random);
Checks check_hit_quad(Generator& random);
Checks check_point_irradiance(Generator& random);
Checks check_phong(Generator& random);
Checks check_shadow_ray(Generator& random);
Checks check_mirror_direction(Generator& random);
Checks check_refracted_direction(Generator& random);
Checks check_fresnel_dielectric(Generator& random);
Checks check_whitted(Generator& random);

Checks check_stratified_2d(Generator& random);
Checks check_uniform_disk(Generator& random);
Checks check_cosine_hemisphere(Generator& random);
Checks check_phong_lobe(Generator& random);
Checks check_sphere_cone(Generator& random);

Checks check_film_sample(Generator& random);
Checks check_pixel_mean(Generator& random);
Checks check_light_sample(Generator& random);
Checks check_direct_light(Generator& random);
Checks check_glossy_reflection(Generator& random);
Checks check_translucency(Generator& random);
Checks check_lens_ray(Generator& random);
Checks check_shutter_time(Generator& random);
Checks check_moved(Generator& random);
Checks check_color_bleeding(Generator& random);
Checks check_emission_counts(Generator& random);
Checks check_free_flight(Generator& random);
Checks check_scatter_direction(Generator& random);

}  // namespace grade
