#include <utility>

#include "checks/kit/draw.h"
#include "checks/fragment_checks.h"

namespace grade {

std::vector<Check> all_checks(std::uint64_t seed) {
    const std::pair<const char*, Checks (*)(Generator&)> fragments[] = {
        {"integrate_uniform", check_integrate_uniform},
        {"integrate_monte_carlo", check_integrate_monte_carlo},
        {"integrate_stratified", check_integrate_stratified},
        {"camera_ray", check_camera_ray},
        {"hit_sphere", check_hit_sphere},
        {"hit_triangle", check_hit_triangle},
        {"hit_quad", check_hit_quad},
        {"point_irradiance", check_point_irradiance},
        {"phong", check_phong},
        {"shadow_ray", check_shadow_ray},
        {"mirror_direction", check_mirror_direction},
        {"refracted_direction", check_refracted_direction},
        {"fresnel_dielectric", check_fresnel_dielectric},
        {"whitted", check_whitted},
        {"stratified_2d", check_stratified_2d},
        {"uniform_disk", check_uniform_disk},
        {"cosine_hemisphere", check_cosine_hemisphere},
        {"phong_lobe", check_phong_lobe},
        {"sphere_cone", check_sphere_cone},
        {"film_sample", check_film_sample},
        {"pixel_mean", check_pixel_mean},
        {"light_sample", check_light_sample},
        {"direct_light", check_direct_light},
        {"glossy_reflection", check_glossy_reflection},
        {"translucency", check_translucency},
        {"lens_ray", check_lens_ray},
        {"shutter_time", check_shutter_time},
        {"moved", check_moved},
        {"color_bleeding", check_color_bleeding},
        {"emission_counts", check_emission_counts},
        {"free_flight", check_free_flight},
        {"scatter_direction", check_scatter_direction},
    };
    std::vector<Check> all;
    for (const auto& [name, checks] : fragments) {
        Generator random = stream(seed, name);
        for (Check& check : checks(random)) {
            check.fragment = name;
            all.push_back(std::move(check));
        }
    }
    return all;
}

}  // namespace grade
