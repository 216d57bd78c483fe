#include <array>

#include "checks/kit/figures.h"
#include "checks/fragment_checks.h"
#include "checks/kit/hit_flat.h"
#include "checks/kit/probe_check.h"

namespace grade {

namespace {

using rt::Quad, rt::Ray, rt::vec3;

vec3 normal_of_quad(const Quad& q) { return rt::unit(rt::cross(q.u, q.v)); }

/// x and y of the point where the line meets the plane: center + x u + y v.
std::array<double, 2> coordinates(const Quad& q, const Ray& ray) {
    const vec3 p = ray.origin + plane_crossing(ray, q.center, normal_of_quad(q)) * ray.direction - q.center;
    return {rt::dot(p, q.u) / rt::dot(q.u, q.u), rt::dot(p, q.v) / rt::dot(q.v, q.v)};
}

Row ordinary_quad(Generator& random, bool clipped) {
    const double size = log_between(random, 0.01, 10);
    const rt::Frame frame = rt::frame_about(direction(random));
    const Quad q{box(random, -5, 5), size * between(random, 0.3, 2) * frame.x,
                 size * between(random, 0.3, 2) * frame.y};
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

}  // namespace

Checks check_hit_quad(Generator& random) {
    const auto at = [](const Quad& q, const Ray& ray) { return plane_crossing(ray, q.center, normal_of_quad(q)); };
    const auto within = [](double low, double high) {
        return [=](const Quad& q, const Ray& ray) {
            const auto [x, y] = coordinates(q, ray);
            return x >= low && x <= high && y >= low && y <= high;
        };
    };
    const auto hit = [=](auto inside) {
        return of<Quad, Ray>([=](const Quad& q, const Ray& ray) {
            const double where = at(q, ray);
            return inside(q, ray) && where > ray.near && where < ray.far ? where : rt::inf;
        });
    };
    std::vector<Suspect> suspects = {
        {"u and v are half edges; they are used as whole ones", hit(within(-0.5, 0.5))},
        {"center is the middle of the quad; it is used as a corner", hit(within(0, 1))},
        {"center is the middle of the quad; it is used as a corner", hit(within(0, 2))},
        {"only |p . u| is tested; |p . v| <= v . v as well",
         hit([](const Quad& q, const Ray& ray) { return std::abs(coordinates(q, ray)[0]) <= 1; })}};
    for (Suspect& s : flat_suspects<Quad>(at, within(-1, 1), normal_of_quad)) suspects.push_back(std::move(s));
    const RowFunction right = hit(within(-1, 1));
    const std::vector<Circumstance> circumstances =
        flat_circumstances<Quad>([](const Quad& q) { return glm::length(q.u) + glm::length(q.v); });
    const auto unclipped = rows_of(96, [](Generator& draw) { return ordinary_quad(draw, false); });
    const auto clipped = rows_of(160, [](Generator& draw) { return ordinary_quad(draw, true); });
    return {probe_check("inside", unclipped, {formula("W1", "distance, off by", right, 1e-3, suspects, circumstances)}),
            probe_check("interval", clipped,
                        {formula("W1", "distance within the interval, off by", right, 1e-3, suspects, circumstances)}),
            slanted_quad(random)};
}

}  // namespace grade
