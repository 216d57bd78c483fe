#include "checks/kit/outline.h"

#include <fmt/format.h>

#include "rt/files/scene_reader.h"
#include "statistics/blob.h"

namespace grade {

bool on_quad(const rt::Quad& quad, rt::vec3 origin, rt::vec3 direction) {
    const rt::vec3 n = rt::cross(quad.u, quad.v);
    const double t = rt::dot(quad.center - origin, n) / rt::dot(direction, n);
    const rt::vec3 p = origin + t * direction - quad.center;
    return t > 0 && std::abs(rt::dot(p, quad.u)) <= rt::dot(quad.u, quad.u) &&
           std::abs(rt::dot(p, quad.v)) <= rt::dot(quad.v, quad.v);
}

/// The mean of what is seen over a pixel: from many points where the outline runs through it. The error of the truth must
/// stay far below what is right in any case.
double seen_in_pixel(int x, int y, const Sight& sight) {
    const double first = sight({x + 0.5, y + 0.5});
    const double off = over_pixel(x, y, [&](rt::vec2 film) { return std::abs(sight(film) - first); });
    return off == 0 ? first : over_pixel(x, y, sight, 32);
}

std::vector<Statistic> figure_statistics(const rt::Camera& camera, const Sight& sight, const std::string& figure) {
    rt::Image expected(camera.size.x, camera.size.y);
    for (int y = 0; y < expected.height; ++y)
        for (int x = 0; x < expected.width; ++x) expected.at(x, y) = rt::Color(seen_in_pixel(x, y, sight));
    const Blob due = blob_moments(expected, whole(expected));
    const auto blob = [](const rt::Image& image) { return blob_moments(image, whole(image)); };

    const auto shift = [figure](const char* axis) {
        return [figure, axis](double value, double) {
            return fmt::format("the {} is seen {:.3g} pixels beside its place, {}", figure, value, axis);
        };
    };
    return {
        of_picture(
            "A1", "place of the " + figure + ", to the right by [pixel]",
            [=](const rt::Image& i) { return blob(i).centroid.x - due.centroid.x; }, 0, 0.15, shift("to the right")),
        of_picture(
            "A1", "place of the " + figure + ", downwards by [pixel]",
            [=](const rt::Image& i) { return blob(i).centroid.y - due.centroid.y; }, 0, 0.15, shift("downwards")),
        of_picture(
            "A1", "width of the " + figure + ", over what must be",
            [=](const rt::Image& i) { return std::sqrt(blob(i).variance.x / due.variance.x); }, 1, 0.02,
            by_ratio("the width of the " + figure, {})),
        of_picture(
            "A1", "height of the " + figure + ", over what must be",
            [=](const rt::Image& i) { return std::sqrt(blob(i).variance.y / due.variance.y); }, 1, 0.02,
            by_ratio("the height of the " + figure, {})),
        of_picture(
            "A1", "light of the " + figure + ", over what must be",
            [=](const rt::Image& i) { return blob(i).mass / due.mass; }, 1, 0.03,
            by_ratio("the light of the " + figure, {{0, "it is not seen"}}))};
}

Check figure_check(const std::string& name, const std::string& scene, const std::string& figure,
                   std::function<Sight(const rt::Camera&)> sight) {
    const rt::Camera camera = rt::parse_scene(scene, name).camera;
    return render_check(name, {scene, 16, "sobol"}, figure_statistics(camera, sight(camera), figure));
}

}  // namespace grade
