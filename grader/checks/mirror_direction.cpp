#include "asked/mirror_direction.h"
#include "checks/kit/figures.h"
#include "checks/kit/kit.h"

namespace grade {

namespace {

using rt::vec3;

/// The part along the normal and the part along the surface, each times a factor: -1 and 1 for a mirror.
auto parts(double along_normal, double along_surface) {
    return [=](vec3 d, vec3 n) {
        const vec3 normal = rt::dot(d, n) * n;
        return vec3(along_normal * normal + along_surface * (d - normal));
    };
}

Check mirror_image(Generator& random) {
    // a camera looks at a mirror, z = 0, at an angle; the quad stands before the mirror
    const Place place = any_place(random);
    const double angle = between(random, 0.2, 1.3), width = between(random, 0.35, 0.45),
                 height = between(random, 0.2, 0.3);
    const vec3 y = place.axes.y, z = place.axes.z;
    const rt::Quad q{place({2.2, between(random, -0.2, 0.2), between(random, 1.1, 1.4)}),
                     width * (std::cos(angle) * z + std::sin(angle) * y),
                     height * (std::cos(angle) * y - std::sin(angle) * z)};
    const View view{place({-2.5, 0, 1.5}), place({0.2, 0, 0}), z, 34, figure_size};
    // the front of the quad, u x v, looks back along -x
    const std::string scene = toml(view) + bright_lamp() + material("mirror", {{"reflectance", 0.8}}) +
                              place.floor("mirror", 1.5) + quad("lamp", q);
    const vec3 origin = place.origin, normal = place.axes.z;
    return figure_check("mirror_image", scene, "mirror image", [=](const rt::Camera& camera) -> Sight {
        return [=](rt::vec2 film) {
            const vec3 d = view_direction(camera, film), p = seen_on_plane(camera, film, origin, normal);
            if (rt::dot(d, normal) >= 0) return on_quad(q, camera.eye, d) ? 1.0 : 0.0;
            const vec3 across = p - origin;
            const bool mirrored =
                std::abs(rt::dot(across, place.axes.x)) <= 1.5 && std::abs(rt::dot(across, place.axes.y)) <= 1.5;
            if (on_quad(q, camera.eye, d)) return 1.0;
            // the image stands behind the mirror
            const vec3 turned = d - 2 * rt::dot(d, normal) * normal;
            return mirrored && on_quad(q, p, turned) ? 0.8 : 0.0;
        };
    });
}

}  // namespace

Checks check_mirror_direction(Generator& random) {
    const auto inputs = rows_of(128, [](Generator& draw) {
        const vec3 n = scene_direction(draw), d = chance(draw, 0.15) ? -n : scene_direction(draw);
        return row((chance(draw, 0.3) ? 1 : range_between(draw, 1e-3, 1e3)) * d, n);
    });
    const Statistic mirrored = formula<rt::mirror_direction>(
        {.id = "W2",
         .what = "mirrored direction, off by",
         .tolerance = 1e-4,
         .right = parts(-1, 1),
         .suspects = {{"the direction is turned round: r has the wrong sign, it must leave the surface", parts(1, -1)},
                      {"d goes straight on: nothing is mirrored", parts(1, 1)},
                      {"d goes straight back", parts(-1, -1)},
                      {"r runs along the surface: the factor 2 is missing", parts(0, 1)},
                      {"the sign before 2 (d . n) n is wrong", parts(3, 1)},
                      {"r has unit length; expected the length of d", [](vec3 right) { return rt::unit(right); }},
                      {"the normal is taken to be on the viewer's side: it may be on either side of the surface",
                       [](vec3 d, vec3 n) { return vec3(d + 2 * std::abs(rt::dot(d, n)) * n); }},
                      {"d . n is taken without its sign: expected no abs()",
                       [](vec3 d, vec3 n) { return vec3(d - 2 * std::abs(rt::dot(d, n)) * n); }}}});
    return {probe_check("mirrored", inputs, {mirrored}), mirror_image(random)};
}

}  // namespace grade
