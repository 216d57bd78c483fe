#include "checks/kit/figures.h"

#include "checks/kit/draw.h"

namespace grade {

using rt::Quad, rt::vec2, rt::vec3;

View view_down(const Place& place, double height, double vfov) {
    return {place({0, 0, height}), place({0, 0, 0}), place.turned({0, 1, 0}), vfov, {48, 40}};
}

Quad any_quad(Generator& random, const Place& place, double z, double size) {
    const double angle = between(random, 0.1, 1.4), x = between(random, -0.3, 0.3), y = between(random, -0.2, 0.2);
    const double width = between(random, 0.7, 1), height = between(random, 0.4, 0.7);
    return {place(size * vec3(x, y, 0) + vec3(0, 0, z)),
            size * width * place.turned({std::cos(angle), std::sin(angle), 0}),
            size * height * place.turned({-std::sin(angle), std::cos(angle), 0})};
}

Check slanted_quad(Generator& random) {
    const Place place = any_place(random);
    const Quad q = any_quad(random, place, 0, 1);
    return figure_check("slanted_quad",
                        toml(view_down(place, 5, between(random, 32, 45))) + bright_lamp + quad("lamp", q), "quad",
                        [q](const rt::Camera& camera) -> Sight {
                            return [=](vec2 film) {
                                return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0;
                            };
                        });
}

}  // namespace grade
