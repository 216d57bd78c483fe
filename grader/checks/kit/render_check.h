#pragma once

#include <string>

#include "checks/kit/estimate.h"
#include "rt/scene.h"
#include "statistics/region.h"

/// Checks that render, and their scenes as text.
namespace grade {

/// Numbers as a scene file has them, with all their digits.
std::string toml(double x);
std::string toml(rt::vec3 v);

/// A camera as a scene file has it.
struct View {
    rt::vec3 eye{0}, target{0}, up{0, 1, 0};
    double vfov = 40;  // [degree]
    rt::ivec2 size{32, 32};
    double lens_radius = 0, focus = 0;  // focus 0: at the target
};

std::string toml(const View& view);
std::string sphere(const std::string& material, rt::vec3 center, double radius, rt::vec3 velocity = rt::vec3(0));
std::string disc(const std::string& material, rt::vec3 center, rt::vec3 normal, double radius,
                 rt::vec3 velocity = rt::vec3(0));
std::string quad(const std::string& material, rt::vec3 center, rt::vec3 u, rt::vec3 v, rt::vec3 velocity = rt::vec3(0));
inline std::string quad(const std::string& material, const rt::Quad& q) { return quad(material, q.center, q.u, q.v); }

/// A scene is set up in a frame of its own, and stands anywhere, turned in any way: place({x, y, z}) is in the world.
struct Place {
    rt::Frame axes;
    rt::vec3 origin;

    rt::vec3 operator()(rt::vec3 local) const { return origin + axes.to_world(local); }
    rt::vec3 turned(rt::vec3 local) const { return axes.to_world(local); }
};
Place any_place(Generator& random);

/// The direction of a pinhole's ray through a film point.
rt::vec3 view_direction(const rt::Camera& camera, rt::vec2 film);

/// Where the ray through a film point meets a plane.
rt::vec3 seen_on_plane(const rt::Camera& camera, rt::vec2 film, rt::vec3 point, rt::vec3 normal);

/// The mean of a function of the film over pixel x, y, from n x n points.
template <class F>
double over_pixel(int x, int y, F f, int n = 4) {
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += f(rt::vec2(x + (i + 0.5) / n, y + (j + 0.5) / n));
    return sum / (n * n);
}

/// A check that renders.
Check render_check(std::string name, Render render, std::vector<Statistic> statistics, int share = 1);

/// A number of the picture; a tenth of delta is right in any case.
Statistic of_picture(std::string id, std::string what, std::function<double(const rt::Image&)> number, double truth,
                     double delta, Hint hint);

/// A hint for a statistic that has known wrong values: the words of those that are nearest, where they are near, or
/// else `else_words`.
Hint by_value(std::string what, std::vector<KnownValue> known, double near, std::string else_words = "");

}  // namespace grade
