#include "asked/hit_quad.h"
#include "checks/kit/figures.h"
#include "checks/kit/hit_flat.h"

namespace grade {

namespace {

using rt::Quad, rt::Ray, rt::vec2, rt::vec3;

vec3 normal_of_quad(const Quad& q) { return rt::unit(rt::cross(q.u, q.v)); }

/// x and y of the point where the line meets the plane: center + x u + y v.
vec2 coordinates(const Quad& q, const Ray& ray) {
    const vec3 p = ray.origin + plane_crossing(ray, q.center, normal_of_quad(q)) * ray.direction - q.center;
    return {rt::dot(p, q.u) / rt::dot(q.u, q.u), rt::dot(p, q.v) / rt::dot(q.v, q.v)};
}

Quad any_quad_of(Generator& random, double size) {
    // along the axes of a frame, or turned in its plane: who measures along such a frame's axes must not be right
    const rt::Frame about = rt::frame_about(scene_direction(random));
    const double turn = chance(random, 0.5) ? 0 : between(random, 0, 2 * rt::pi);
    const rt::Frame frame{std::cos(turn) * about.x + std::sin(turn) * about.y,
                          std::cos(turn) * about.y - std::sin(turn) * about.x, about.z};
    const double thin = chance(random, 0.15) ? log_between(random, 1e-3, 0.3) : 1;
    return {box(random, -5, 5), size * between(random, 0.3, 2) * frame.x,
            thin * size * between(random, 0.3, 2) * frame.y};
}

Row ordinary_quad(Generator& random, bool clipped) {
    const double size = scene_size(random);
    const Quad q = any_quad_of(random, size);
    const double reach = chance(random, 0.6) ? 0.97 : 2.5;
    double x, y;
    do x = between(random, -reach, reach), y = between(random, -reach, reach);
    while (std::abs(std::abs(x) - 1) < 0.03 || std::abs(std::abs(y) - 1) < 0.03);
    // some close to the rim, on either side: a fault there is seen in few pixels
    if (chance(random, 0.6)) {
        x = std::copysign(1 + close_to_zero(random, 1e-6), x), y = between(random, -0.97, 0.97);
        if (chance(random, 0.5)) std::swap(x, y);
    }
    return row(q, ray_towards(random, q.center + x * q.u + y * q.v, normal_of_quad(q), size, clipped));
}

Row fine_quad(Generator& random) {
    const double size = log_between(random, 1e-3, 1e-2);
    const Quad q = any_quad_of(random, size);
    const double x = 1 + hair(random), y = between(random, -0.97, 0.97);
    const vec3 target = chance(random, 0.5) ? q.center + x * q.u + y * q.v : q.center + y * q.u + x * q.v;
    return row(q, ray_from_afar(random, target, normal_of_quad(q), size));
}

Row rim_of_quad(Generator& random) {
    const ExactFrame frame = exact_frame(random);
    const Quad q{frame.corner, frame.x, double(whole_between(random, 1, 2)) * frame.y};
    double x = chance(random, 0.5) ? 1 : -1, y = 0.25 * whole_between(random, -4, 4);
    if (chance(random, 0.5)) std::swap(x, y);
    return row(q, exact_ray(random, q.center + x * q.u + y * q.v, frame));
}

Row small_quad(Generator& random, Small which) {
    const double size = small_size(random, which);
    const rt::Frame frame = rt::frame_about(direction(random));
    if (which == Small::any && chance(random, 0.2)) {
        const Quad flat{vec3(0), {size, 0, 0}, {0, size, 0}};
        return row(flat, Ray{{-2 * size, 0, chance(random, 0.5) ? 0 : size}, {1, 0, 0}, 0, rt::inf});
    }
    const Quad q{size * box(random, -1, 1), size * frame.x, size * frame.y};
    const double reach = which != Small::any || chance(random, 0.7) ? 0.95 : 2.5;
    double x, y;
    do x = between(random, -reach, reach), y = between(random, -reach, reach);
    while (std::abs(std::abs(x) - 1) < 0.03 || std::abs(std::abs(y) - 1) < 0.03);
    return row(q, near_ray(random, q.center + x * q.u + y * q.v, frame.z, size, which));
}

/// Whether a point is on the quad, or would be if that reached from low to high.
auto within(double low, double high) {
    return [=](const Quad& q, const Ray& ray) {
        const vec2 p = coordinates(q, ray);
        return p.x >= low && p.x <= high && p.y >= low && p.y <= high;
    };
}

/// Whether |p . u| and |p . v| are at most what `limit` makes of the edges.
auto up_to(double (*limit)(vec3 edge)) {
    return [=](const Quad& q, const Ray& ray) {
        const vec2 p = coordinates(q, ray);
        return std::abs(p.x) * rt::dot(q.u, q.u) <= limit(q.u) && std::abs(p.y) * rt::dot(q.v, q.v) <= limit(q.v);
    };
}

}  // namespace

Checks check_hit_quad(Generator& random) {
    const FlatShape<Quad> flat{.point = [](const Quad& q) { return q.center; },
                               .normal = normal_of_quad,
                               .product = [](const Quad& q) { return rt::cross(q.u, q.v); },
                               .inside = within(-1, 1),
                               .on_rim =
                                   [](const Quad& q, const Ray& ray) {
                                       const vec2 p = glm::abs(coordinates(q, ray));
                                       return std::max(p.x, p.y) == 1;
                                   },
                               .size = [](const Quad& q) { return glm::length(q.u) + glm::length(q.v); }};
    const auto strip = [](const Quad& q, const Ray& ray) { return std::abs(coordinates(q, ray).x) <= 1; };
    const auto length = [](vec3 edge) { return glm::length(edge); };
    const auto one = [](vec3) { return 1.0; };
    const std::vector<Suspect<rt::hit_quad>> of_quads = {
        {"|p . u| is compared with |u|, and |p . v| with |v|; expected u . u and v . v, the squares of the lengths",
         hit_where(flat, up_to(length), in_interval)},
        {"|p . u| and |p . v| are compared with 1; expected u . u and v . v", hit_where(flat, up_to(one), in_interval)},
        {"u and v are half edges; they are used as whole ones", hit_where(flat, within(-0.5, 0.5), in_interval)},
        {"center is the middle of the quad; it is used as a corner", hit_where(flat, within(0, 1), in_interval)},
        {"center is the middle of the quad; it is used as a corner", hit_where(flat, within(0, 2), in_interval)},
        {"only |p . u| is tested; |p . v| <= v . v as well", hit_where(flat, strip, in_interval)}};
    const auto suspects = joined(of_quads, flat_suspects<rt::hit_quad>(flat));
    return joined(flat_checks<rt::hit_quad>(flat, suspects, ordinary_quad, fine_quad, rim_of_quad, small_quad),
                  {slanted_quad(random)});
}

}  // namespace grade
