#include "checks/kit/figures.h"

#include "checks/kit/later.h"
#include "statistics/blob.h"

namespace grade {

using rt::Quad, rt::vec2, rt::vec3;

namespace {

/// The mean of what is seen over a pixel: from many points where the outline runs through it. The error of the truth
/// must stay far below what is right in any case.
double seen_in_pixel(int x, int y, const Sight& sight) {
    const double first = sight({x + 0.5, y + 0.5});
    const double off = over_pixel(x, y, [&](rt::vec2 film) { return std::abs(sight(film) - first); });
    return off == 0 ? first : over_pixel(x, y, sight, 32);
}

Blob due_moments(const rt::Camera& camera, const Sight& sight) {
    const rt::Image expected = picture_of(camera.size, [&](int x, int y) { return seen_in_pixel(x, y, sight); });
    return blob_of(expected);
}

std::vector<Statistic> figure_statistics(const rt::Camera& camera, const Sight& sight, const std::string& figure) {
    const auto due = later([=] { return due_moments(camera, sight); });

    const auto beside = [&](const std::string& axis, PictureNumber off) {
        return of_picture({.id = "A1",
                           .what = "place of the " + figure + ", " + axis + " by [pixel]",
                           .number = std::move(off),
                           .truth = 0,
                           .delta = 0.15,
                           .hint = with_value("the " + figure + " is seen {:.3g} pixels beside its place, " + axis)});
    };
    const auto ratio = [&](const std::string& of, double delta, PictureNumber squared) {
        return of_picture({.id = "A1",
                           .what = of + figure + ", over what must be",
                           .number = [=](const rt::Image& image) { return std::sqrt(squared(image)); },
                           .delta = delta,
                           .hint = by_ratio("the " + of + figure, {})});
    };
    const Statistic light = of_picture({.id = "A1",
                                        .what = "light of the " + figure + ", over what must be",
                                        .number = [=](const rt::Image& i) { return blob_of(i).mass / due().mass; },
                                        .delta = 0.03,
                                        .hint = by_ratio("the light of the " + figure, {{0, "it is not seen"}})});
    return {beside("to the right", [=](const rt::Image& i) { return blob_of(i).centroid.x - due().centroid.x; }),
            beside("downwards", [=](const rt::Image& i) { return blob_of(i).centroid.y - due().centroid.y; }),
            ratio("width of the ", 0.02, [=](const rt::Image& i) { return blob_of(i).variance.x / due().variance.x; }),
            ratio("height of the ", 0.02, [=](const rt::Image& i) { return blob_of(i).variance.y / due().variance.y; }),
            light};
}

}  // namespace

Check figure_check(const std::string& name, const std::string& scene, const std::string& figure,
                   std::function<Sight(const rt::Camera&)> sight) {
    const rt::Camera camera = camera_of(scene);
    return render_check(name, {scene, 16, "sobol"}, figure_statistics(camera, sight(camera), figure));
}

bool on_quad(const rt::Quad& quad, rt::vec3 origin, rt::vec3 direction) {
    const rt::vec3 n = rt::cross(quad.u, quad.v);
    const double t = rt::dot(quad.center - origin, n) / rt::dot(direction, n);
    const rt::vec3 p = origin + t * direction - quad.center;
    return t > 0 && std::abs(rt::dot(p, quad.u)) <= rt::dot(quad.u, quad.u) &&
           std::abs(rt::dot(p, quad.v)) <= rt::dot(quad.v, quad.v);
}

Sight sight_of(const Quad& q, const rt::Camera& camera) {
    return [=](vec2 film) { return on_quad(q, camera.eye, view_direction(camera, film)) ? 1.0 : 0.0; };
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
    const double vfov = between(random, 32, 45);
    return figure_check("slanted_quad", toml(place.from_above(5, vfov, figure_size)) + bright_lamp() + quad("lamp", q),
                        "quad", [q](const rt::Camera& camera) { return sight_of(q, camera); });
}

}  // namespace grade
