#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "asked/hit_triangle.h"
#include "checks/kit/figures.h"
#include "checks/kit/hit_flat.h"

namespace grade {

namespace {

using rt::Ray, rt::Triangle, rt::vec3;

vec3 normal_of_triangle(const Triangle& t) { return rt::unit(rt::cross(t.b - t.a, t.c - t.a)); }

/// The shares of the three corners in the point where the line meets the plane: areas of the parts over the whole.
std::array<double, 3> shares(const Triangle& t, const Ray& ray) {
    const vec3 n = normal_of_triangle(t), p = ray.origin + plane_crossing(ray, t.a, n) * ray.direction;
    const double whole = rt::dot(rt::cross(t.b - t.a, t.c - t.a), n);
    return {rt::dot(rt::cross(t.b - p, t.c - p), n) / whole, rt::dot(rt::cross(t.c - p, t.a - p), n) / whole,
            rt::dot(rt::cross(t.a - p, t.b - p), n) / whole};
}

/// A triangle that is not too thin, often half of a wall or a floor.
Triangle any_triangle_of(Generator& random, double size) {
    const vec3 center = box(random, -5, 5);
    if (chance(random, 0.1)) {  // a ramp of 45 degrees: two parts of its normal are as large
        const int along = whole_between(random, 0, 2);
        vec3 up(size * between(random, 0.5, 1)), side(0);
        up[along] = 0, side[along] = size * between(random, 0.5, 1);
        return {vec3(0), up, side};
    }
    if (chance(random, 0.4)) {
        const rt::Frame frame = rt::frame_about(scene_direction(random));
        const vec3 x = size * between(random, 0.5, 1) * frame.x, y = size * between(random, 0.5, 1) * frame.y;
        return {center, center + x, center + y};
    }
    Triangle t;
    do t = {center + size * box(random, -1, 1), center + size * box(random, -1, 1), center + size * box(random, -1, 1)};
    while (glm::length(rt::cross(t.b - t.a, t.c - t.a)) < 0.4 * size * size);
    return t;
}

vec3 on_triangle(const Triangle& t, const std::array<double, 3>& share) {
    return share[0] * t.a + share[1] * t.b + share[2] * t.c;
}

/// A ray to a point that is clearly inside or outside, or close to an edge.
Row ordinary_triangle(Generator& random, bool clipped) {
    const double size = scene_size(random);
    const Triangle t = any_triangle_of(random, size);

    std::array<double, 3> share;
    const double low = chance(random, 0.6) ? 0.02 : -1;
    do {
        share[0] = between(random, low, 1), share[1] = between(random, low, 1), share[2] = 1 - share[0] - share[1];
    } while (*std::min_element(share.begin(), share.end()) < low ||
             std::abs(*std::min_element(share.begin(), share.end())) < 0.02);
    std::rotate(share.begin(), share.begin() + whole_between(random, 0, 2), share.end());  // beyond each corner
    // some close to an edge, on either side: a fault there is seen in few pixels
    if (chance(random, 0.35)) {
        const double before = share[0];
        share[0] = close_to_zero(random, 1e-6);
        share[1] += before - share[0];
    }
    return row(t, ray_towards(random, on_triangle(t, share), normal_of_triangle(t), size, clipped));
}

Row fine_triangle(Generator& random) {
    const double size = log_between(random, 1e-3, 1e-2);
    const Triangle t = any_triangle_of(random, size);
    std::array<double, 3> share{hair(random), between(random, 0.2, 0.8), 0};
    share[2] = 1 - share[0] - share[1];
    std::rotate(share.begin(), share.begin() + whole_between(random, 0, 2), share.end());
    return row(t, ray_from_afar(random, on_triangle(t, share), normal_of_triangle(t), size));
}

Row rim_of_triangle(Generator& random) {
    const ExactFrame frame = exact_frame(random);
    std::array corners{frame.corner, frame.corner + frame.x, frame.corner + frame.y};
    std::rotate(corners.begin(), corners.begin() + whole_between(random, 0, 2), corners.end());
    const Triangle t{corners[0], corners[1], corners[2]};
    const double along = 0.25 * whole_between(random, 0, 4);
    std::array share{0.0, along, 1 - along};
    std::rotate(share.begin(), share.begin() + whole_between(random, 0, 2), share.end());
    return row(t, exact_ray(random, on_triangle(t, share), frame));
}

Row small_triangle(Generator& random, Small which) {
    const double size = small_size(random, which);
    if (which == Small::any && chance(random, 0.2)) {
        const Triangle flat{{-size, -size, 0}, {size, -size, 0}, {0, size, 0}};
        return row(flat, Ray{{-2 * size, 0, chance(random, 0.5) ? 0 : size}, {1, 0, 0}, 0, rt::inf});
    }
    const rt::Frame frame = rt::frame_about(direction(random));
    const vec3 center = size * box(random, -1, 1);
    const Triangle t{center - size * frame.x - size * frame.y, center + size * frame.x - size * frame.y,
                     center + size * frame.y};
    const double x = between(random, -0.3, 0.3),
                 y = between(random, -0.7, 0.3) - (which == Small::any && chance(random, 0.3) ? 2 : 0);
    return row(t, near_ray(random, center + size * (x * frame.x + y * frame.y), frame.z, size, which));
}

Check two_triangles(Generator& random) {
    const Place place = any_place(random);
    const rt::Quad q = any_quad(random, place, 0, 1);
    const vec3 a = q.center - q.u - q.v, b = q.center + q.u - q.v, c = q.center + q.u + q.v, d = q.center - q.u + q.v;
    const std::string scene = toml(place.from_above(5, 40, figure_size)) + unsampled_lamp("lamp", 1) +
                              triangle("lamp", a, b, c) + triangle("lamp", a, c, d);
    Check check = figure_check("two_triangles", scene, "pair of triangles",
                               [q](const rt::Camera& camera) { return sight_of(q, camera); });
    check.statistics.push_back(of_picture({.id = "A1",
                                           .what = "brightest pixel, off 1 by",
                                           .number =
                                               [](const rt::Image& image) {
                                                   double most = 0;
                                                   for (const rt::Color& c : image.pixels) most = std::max(most, c.x);
                                                   return std::abs(most - 1);
                                               },
                                           .truth = 0,
                                           .delta = 1e-9,
                                           .exact = true,
                                           .hint = always("the figure's radiance is 1")}));
    return check;
}

/// The suspects of any flat shape, and points beyond the edges.
std::vector<Suspect<rt::hit_triangle>> triangle_suspects(const FlatShape<Triangle>& flat) {
    std::vector<Suspect<rt::hit_triangle>> suspects = flat_suspects<rt::hit_triangle>(flat);
    const auto parallelogram = [](const Triangle& t, const Ray& ray) {
        const auto [a, b, c] = shares(t, ray);
        return b >= 0 && c >= 0 && b <= 1 && c <= 1;
    };
    suspects.push_back({"the parallelogram of which the triangle is one half is hit: is u + v <= 1 tested?",
                        hit_where(flat, parallelogram, in_interval)});
    // two edges of three, as conditions on the shares, with or without regard to the side
    for (const auto& [i, j, edge] :
         {std::tuple(0, 1, "from a to b"), std::tuple(1, 2, "from b to c"), std::tuple(0, 2, "from c to a")})
        for (const bool either_sign : {false, true}) {
            const auto two_edges = [=, i = i, j = j](const Triangle& t, const Ray& ray) {
                const auto share = shares(t, ray);
                return (share[i] >= 0 && share[j] >= 0) || (either_sign && share[i] <= 0 && share[j] <= 0);
            };
            suspects.push_back(
                {fmt::format("points outside the edge {} count as inside: that edge is not tested", edge),
                 hit_where(flat, two_edges, in_interval)});
        }
    return suspects;
}

}  // namespace

Checks check_hit_triangle(Generator& random) {
    const auto inside = [](const Triangle& t, const Ray& ray) {
        const auto [a, b, c] = shares(t, ray);
        return a >= 0 && b >= 0 && c >= 0;
    };
    const FlatShape<Triangle> flat{
        .point = [](const Triangle& t) { return t.a; },
        .normal = normal_of_triangle,
        .product = [](const Triangle& t) { return rt::cross(t.b - t.a, t.c - t.a); },
        .inside = inside,
        .on_rim =
            [](const Triangle& t, const Ray& ray) {
                const auto share = shares(t, ray);
                return std::ranges::min(share) == 0;
            },
        .size = [](const Triangle& t) { return glm::length(t.b - t.a) + glm::length(t.c - t.a); }};
    const auto nothing = rows_of(24, [](Generator& draw) {
        const vec3 a = box(draw, -1, 1), b = box(draw, -1, 1), origin = box(draw, 3, 4);
        const Triangle thin = chance(draw, 0.5) ? Triangle{a, a, b} : Triangle{a, b, a};
        return row(thin, Ray{origin, rt::unit(a + between(draw, 0, 1) * (b - a) - origin), 0, rt::inf});
    });
    const Statistic never =
        property({.id = "W1",
                  .what = "a triangle without area is hit",
                  .violation = of_call<rt::hit_triangle>([](double t) { return t == rt::inf ? 0.0 : 1.0; }),
                  .says = "a triangle whose corners coincide must give inf, not nan or a hit"});
    return joined(flat_checks<rt::hit_triangle>(flat, triangle_suspects(flat), ordinary_triangle, fine_triangle,
                                                rim_of_triangle, small_triangle),
                  {probe_check("no_area", nothing, {never}), two_triangles(random)});
}

}  // namespace grade
