#include "checks/kit/film_view.h"

namespace grade {

using rt::vec2, rt::vec3;

View film_view(const Place& place, rt::ivec2 size) {
    return place.from_above(5, vfov_of(size.y * film_pixel / 2, 5), size);
}

std::string bright(const Place& place, rt::ivec2 size, const std::string& material, vec2 center, vec2 u, vec2 v) {
    const auto turned = [&](vec2 d) { return place.turned(film_pixel * vec3(d.x, -d.y, 0)); };
    const vec2 c = center - 0.5 * vec2(size);
    const vec3 across = turned(u), along = turned(v);
    // the front side faces the camera
    const bool faces = rt::dot(rt::cross(across, along), place.axes.z) > 0;
    return quad(material, place(film_pixel * vec3(c.x, -c.y, 0)), across, faces ? along : -along);
}

}  // namespace grade
