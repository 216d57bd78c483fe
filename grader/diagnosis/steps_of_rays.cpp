#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

Row camera_direction(const Camera& camera, Real x, Real y) {
    return row(Ray{camera.eye, unit(x * camera.right + y * camera.up - camera.back), 0, inf});
}

std::vector<Steps> of_camera() {
    return {steps(
                "x * right + y * up - back", "Real x; Real y",
                +[](const Camera& c, const vec2& film) {
                    const Real scale = 2 * c.tan_half_fov / c.size.y;
                    return row(scale * (film.x - 0.5 * c.size.x), scale * (0.5 * c.size.y - film.y));
                },
                +[](const double* s, const Camera& c, const vec2&) { return camera_direction(c, s[0], s[1]); }),
            steps(
                "x = scale * (film.x - half_width), y = scale * (half_height - film.y), scale = 2 * tan_half_fov / "
                "size.y",
                "Real half_width; Real half_height; Real scale; Real 2 * tan_half_fov / size.x",
                +[](const Camera& c, const vec2&) {
                    const Real size = 2 * c.tan_half_fov;
                    return row(0.5 * c.size.x, 0.5 * c.size.y, size / c.size.y, size / c.size.x);
                },
                +[](const double* s, const Camera& c, const vec2& film) {
                    return camera_direction(c, s[2] * (film.x - s[0]), s[2] * (s[1] - film.y));
                }),
            steps(
                "x = (2 * film.x / camera.size.x - 1) * aspect * tan_half_fov, aspect = camera.size.x / camera.size.y",
                "Real aspect; Real y",
                +[](const Camera& c, const vec2& film) {
                    return row(Real(c.size.x) / c.size.y, (1 - 2 * film.y / c.size.y) * c.tan_half_fov);
                },
                +[](const double* s, const Camera& c, const vec2& film) {
                    return camera_direction(c, (2 * film.x / c.size.x - 1) * s[0] * c.tan_half_fov, s[1]);
                })};
}

Row first_root(Real near_root, Real far_root, const Ray& ray) {
    for (const Real t : {near_root, far_root})
        if (t > ray.near && t < ray.far) return row(t);
    return row(inf);
}

std::vector<Steps> of_sphere() {
    return {
        steps(
            "(b -+ root) / a, root = sqrt(b * b - a * c), a = dot(d, d), b = -dot(f, d), c = dot(f, f) - r^2, f = "
            "origin - center",
            "Real a; Real b; Real c; Real root",
            +[](const Sphere& sphere, const Ray& ray) {
                const vec3 f = ray.origin - sphere.center;
                const Real a = dot(ray.direction, ray.direction), b = -dot(f, ray.direction),
                           c = dot(f, f) - sqr(sphere.radius);
                return row(a, b, c, std::sqrt(b * b - a * c));
            },
            +[](const double* s, const Sphere& sphere, const Ray& ray) {
                const vec3 f = ray.origin - sphere.center;
                const Real a = dot(ray.direction, ray.direction), b = -dot(f, ray.direction),
                           c = dot(f, f) - sqr(sphere.radius);
                const bool is_other = s[0] != a || s[1] != b || s[2] != c;
                const Real root = is_other ? std::sqrt(s[1] * s[1] - s[0] * s[2]) : s[3];
                if (!(root == root)) return row(inf);
                return first_root((s[1] - root) / s[0], (s[1] + root) / s[0], ray);
            }),
        steps(
            "(-b -+ sqrt(b^2 - 4 * a * c)) / (2 * a), b = 2 * dot(f, d), c = dot(f, f) - r^2, f = origin - center",
            "Real b^2; Real 4 * a * c; Real 2 * a; Real -b; Real b^2 - 4 * a * c",
            +[](const Sphere& sphere, const Ray& ray) {
                const vec3 f = ray.origin - sphere.center;
                const Real a = dot(ray.direction, ray.direction), b = 2 * dot(f, ray.direction),
                           ac4 = 4 * a * (dot(f, f) - sqr(sphere.radius));
                return row(b * b, ac4, 2 * a, -b, b * b - ac4);
            },
            +[](const double* s, const Sphere& sphere, const Ray& ray) {
                const vec3 f = ray.origin - sphere.center;
                const Real d0 = sqr(2 * dot(f, ray.direction)) -
                                4 * dot(ray.direction, ray.direction) * (dot(f, f) - sqr(sphere.radius));
                // what is changed in the last one, or in those before it
                const Real d = s[4] != d0 ? s[4] : s[0] - s[1];
                if (!(d >= 0)) return row(inf);
                return first_root((s[3] - std::sqrt(d)) / s[2], (s[3] + std::sqrt(d)) / s[2], ray);
            }),
        steps(
            "",
            "Real the near root; Real the far root; bool the far root alone; bool the near root alone; bool roots up "
            "to `near` counted; bool roots from `far` on counted; bool the near root taken where it is above 0, even "
            "if it is not above `near`, and the far one not tried; bool the far root taken only where the near one is "
            "below 0; bool the near root taken only where the ray starts outside of the sphere, and the far one "
            "only where it starts inside; bool the point of the ray that is nearest to the centre: half of the way "
            "through the sphere is not taken off",
            +[](const Sphere& sphere, const Ray& ray) {
                const vec3 f = ray.origin - sphere.center;
                const Real a = dot(ray.direction, ray.direction), b = -dot(f, ray.direction);
                const Real d = sqr(sphere.radius) - dot(f + b / a * ray.direction, f + b / a * ray.direction);
                const Real root = std::sqrt(a * d);
                return row((b - root) / a, (b + root) / a, false, false, false, false, false, false, false, false);
            },
            +[](const double* s, const Sphere& sphere, const Ray& ray) {
                if (!(s[0] == s[0])) return row(inf);
                const bool is_inside = length(ray.origin - sphere.center) < sphere.radius;
                if (s[6] != 0) return first_root(s[0] > 0 ? s[0] : s[1], inf, ray);
                if (s[7] != 0) return first_root(s[0], s[0] < 0 ? s[1] : inf, ray);
                if (s[9] != 0) return first_root((s[0] + s[1]) / 2, inf, ray);
                if (s[8] != 0) return first_root(is_inside ? s[1] : s[0], inf, ray);
                const Ray wide{ray.origin, ray.direction, s[4] != 0 ? -inf : ray.near, s[5] != 0 ? inf : ray.far};
                return first_root(s[2] != 0 ? s[1] : s[0], s[3] != 0 ? s[0] : s[1], wide);
            })};
}

std::vector<Steps> of_triangle() {
    return {steps(
        "t where none of the weights of the corners is negative; det = dot(b - a, cross(d, c - a))",
        "Real the weight of a; Real the weight of b; Real the weight of c; Real t; Real det; bool hits before `near` "
        "counted; bool hits beyond `far` counted; bool the sign of the weight of a not tested; bool the sign of the "
        "weight of b not tested; bool the sign of the weight of c not tested; bool the sign of the weight of c not "
        "tested, but whether that of b is at most 1",
        +[](const Triangle& triangle, const Ray& ray) {
            const vec3 b = triangle.b - triangle.a, c = triangle.c - triangle.a, o = ray.origin - triangle.a;
            const vec3 p = cross(ray.direction, c), q = cross(o, b);
            const Real det = dot(b, p), v = dot(o, p) / det, w = dot(ray.direction, q) / det;
            Row taken = row(1 - v - w, v, w, dot(c, q) / det, det);
            taken.resize(11);
            return taken;
        },
        +[](const double* s, const Triangle&, const Ray& ray) {
            const bool of_c = s[10] != 0 ? s[1] <= 1 : s[9] != 0 || s[2] >= 0;
            const bool inside = (s[7] != 0 || s[0] >= 0) && (s[8] != 0 || s[1] >= 0) && of_c;
            return row(inside && (s[5] != 0 || s[3] > ray.near) && (s[6] != 0 || s[3] < ray.far) ? s[3] : inf);
        })};
}

/// As Moller and Trumbore have it.
Steps of_triangle_vectors() {
    return steps(
        "u = dot(s, p) / det, v = dot(d, q) / det, t = dot(e2, q) / det, det = dot(e1, p), p = cross(d, e2), q = "
        "cross(s, e1), s = o - a, e1 = b - a, e2 = c - a",
        "vec3 s; vec3 d; vec3 e2; vec3 e1; vec3 p; vec3 q; bool u <= 1 and v <= 1 tested, not u + v <= 1; bool u >= 0 "
        "and v >= 0 not tested; bool v >= 0 not tested; bool u >= 0 not tested; bool u and v not divided by det; bool "
        "nothing divided by det; bool u + v <= 1 not tested; bool only hits with det > 0 counted; bool only hits with "
        "det < 0 counted",
        +[](const Triangle& triangle, const Ray& ray) {
            const vec3 e1 = triangle.b - triangle.a, e2 = triangle.c - triangle.a, s = ray.origin - triangle.a;
            Row taken = row(s, ray.direction, e2, e1, cross(ray.direction, e2), cross(s, e1));
            taken.resize(27);
            return taken;
        },
        +[](const double* s, const Triangle& triangle, const Ray& ray) {
            const auto step = [s](int i) { return vec3(s[3 * i], s[3 * i + 1], s[3 * i + 2]); };
            const vec3 c1 = triangle.b - triangle.a, c2 = triangle.c - triangle.a, to = ray.origin - triangle.a;
            const vec3 o = step(0), d = step(1), e2 = step(2), e1 = step(3);
            // what is made of others follows their changes
            const vec3 p = step(4) != cross(ray.direction, c2) ? step(4) : cross(d, e2);
            const vec3 q = step(5) != cross(to, c1) ? step(5) : cross(o, e1);
            const Real det = dot(e1, p), under = s[22] != 0 || s[23] != 0 ? 1 : det;
            const Real u = dot(o, p) / under, v = dot(d, q) / under, t = dot(e2, q) / (s[23] != 0 ? 1 : det);
            const bool above = (s[19] != 0 || s[21] != 0 || u >= 0) && (s[19] != 0 || s[20] != 0 || v >= 0);
            const bool below = s[24] != 0 || (s[18] != 0 ? u <= 1 && v <= 1 : u + v <= 1);
            const bool side = (s[25] == 0 || det > 0) && (s[26] == 0 || det < 0);
            return row(above && below && side && t > ray.near && t < ray.far ? t : inf);
        });
}

std::vector<Steps> of_quad() {
    return {
        steps(
            "t = dot(center - origin, n) / dot(d, n), n = cross(u, v)",
            "Real dot(center - origin, n); Real dot(d, n); Real dot(center - origin, unit(n)); Real dot(d, unit(n)); "
            "Real "
            "dot(center, n); Real dot(origin, n)",
            +[](const Quad& quad, const Ray& ray) {
                const vec3 n = cross(quad.u, quad.v), to = quad.center - ray.origin, d = ray.direction;
                return row(dot(to, n), dot(d, n), dot(to, unit(n)), dot(d, unit(n)), dot(quad.center, n),
                           dot(ray.origin, n));
            },
            +[](const double* s, const Quad& quad, const Ray& ray) {
                const Real t = s[0] / s[1];
                const vec3 p = ray.origin + t * ray.direction - quad.center;
                const bool inside =
                    std::abs(dot(p, quad.u)) <= dot(quad.u, quad.u) && std::abs(dot(p, quad.v)) <= dot(quad.v, quad.v);
                return row(inside && t > ray.near && t < ray.far ? t : inf);
            }),
        steps(
            "abs(dot(p, u)) > dot(u, u) || abs(dot(p, v)) > dot(v, v): no hit",
            "Real dot(p, u); Real dot(u, u); Real dot(p, v); Real dot(v, v); bool `&&` in place of `||` between the "
            "tests along u and v; bool no test along u; bool no test along v; bool no abs(): only one edge of two "
            "tested; bool hits before `near` counted; bool hits beyond `far` counted; bool the sum of both tested: "
            "abs(dot(p, u)) / dot(u, u) + abs(dot(p, v)) / dot(v, v) <= 1",
            +[](const Quad& quad, const Ray& ray) {
                const vec3 n = cross(quad.u, quad.v);
                const vec3 p =
                    ray.origin - quad.center + dot(quad.center - ray.origin, n) / dot(ray.direction, n) * ray.direction;
                Row all = row(dot(p, quad.u), dot(quad.u, quad.u), dot(p, quad.v), dot(quad.v, quad.v));
                all.resize(11);
                return all;
            },
            +[](const double* s, const Quad& quad, const Ray& ray) {
                const vec3 n = cross(quad.u, quad.v);
                const Real t = dot(quad.center - ray.origin, n) / dot(ray.direction, n);
                const auto size = [&](Real x) { return s[7] != 0 ? x : std::abs(x); };
                const bool along_u = s[5] != 0 || size(s[0]) <= s[1], along_v = s[6] != 0 || size(s[2]) <= s[3];
                const bool inside = s[10] != 0  ? size(s[0]) / s[1] + size(s[2]) / s[3] <= 1
                                    : s[4] != 0 ? along_u || along_v
                                                : along_u && along_v;
                return row(inside && (s[8] != 0 || t > ray.near) && (s[9] != 0 || t < ray.far) ? t : inf);
            })};
}

/// What quads and spheres are measured with: vectors.
Steps of_quad_vectors() {
    return steps(
        "t = dot(to, n) / dot(d, n), to = center - origin, abs(dot(p, u)) <= dot(u, u) && abs(dot(p, v)) <= dot(v, v), "
        "p = origin + t * d - center",
        "vec3 p; vec3 to; vec3 n",
        +[](const Quad& quad, const Ray& ray) {
            const vec3 n = cross(quad.u, quad.v), to = quad.center - ray.origin;
            return row(dot(to, n) / dot(ray.direction, n) * ray.direction - to, to, n);
        },
        +[](const double* s, const Quad& quad, const Ray& ray) {
            const vec3 usual = cross(quad.u, quad.v), center = quad.center - ray.origin, to(s[3], s[4], s[5]),
                       n(s[6], s[7], s[8]);
            const Real t = dot(to, n) / dot(ray.direction, n);
            const vec3 p = to != center || n != usual ? t * ray.direction - center : vec3(s[0], s[1], s[2]);
            const bool inside =
                std::abs(dot(p, quad.u)) <= dot(quad.u, quad.u) && std::abs(dot(p, quad.v)) <= dot(quad.v, quad.v);
            return row(inside && t > ray.near && t < ray.far ? t : inf);
        });
}

Steps of_sphere_vectors() {
    return steps(
        "b = -dot(f, d), c = dot(f', f') - r^2, f = f' = origin - center", "vec3 f; vec3 f'",
        +[](const Sphere& sphere, const Ray& ray) {
            const vec3 f = ray.origin - sphere.center;
            return row(f, f);
        },
        +[](const double* s, const Sphere& sphere, const Ray& ray) {
            const vec3 f(s[0], s[1], s[2]), other(s[3], s[4], s[5]);
            const Real a = dot(ray.direction, ray.direction), b = -dot(f, ray.direction);
            const Real d = b * b - a * (dot(other, other) - sqr(sphere.radius));
            if (!(d >= 0)) return row(inf);
            return first_root((b - std::sqrt(d)) / a, (b + std::sqrt(d)) / a, ray);
        });
}

std::vector<Steps> of_mirror() {
    return {steps(
        "d - 2 * dot(d, n) * n", "Real dot(d, n)", +[](const vec3& d, const vec3& n) { return row(dot(d, n)); },
        +[](const double* s, const vec3& d, const vec3& n) { return row(d - 2 * s[0] * n); })};
}

std::vector<Steps> of_refraction() {
    return {
        steps(
            "e * d + (e * c - root) * n, e = ior_from / ior_to, c = -dot(d, n), root = sqrt(1 - e^2 * (1 - c^2))",
            "Real e; Real e * c; Real c; Real root; bool d returned at total internal reflection; bool d mirrored "
            "at total internal reflection; bool the test for total internal reflection the wrong way round: nothing "
            "returned where light passes",
            +[](const vec3& d, const vec3& n, const Real& from, const Real& to) {
                const Real e = from / to, c = -dot(d, n);
                return row(e, e * c, c, std::sqrt(1 - e * e * (1 - c * c)), false, false, false);
            },
            +[](const double* s, const vec3& d, const vec3& n, const Real&, const Real&) {
                if (s[6] != 0) return row(s[3] > 0 ? vec3(0) : s[0] * d + s[1] * n);
                const vec3 nothing = s[4] != 0 ? d : s[5] != 0 ? d - 2 * dot(d, n) * n : vec3(0);
                return row(s[3] >= 0 || s[3] < 0 ? s[0] * d + (s[1] - s[3]) * n : nothing);
            }),
        steps(
            "root = sqrt(1 - e^2 * (1 - c^2)), e = ior_from / ior_to, c = -dot(d, n)",
            "Real e^2; Real c^2; Real 1 - c^2; Real 1 - e^2 * (1 - c^2)",
            +[](const vec3& d, const vec3& n, const Real& from, const Real& to) {
                const Real e = from / to, c = -dot(d, n);
                return row(e * e, c * c, 1 - c * c, 1 - e * e * (1 - c * c));
            },
            +[](const double* s, const vec3& d, const vec3& n, const Real& from, const Real& to) {
                const Real e = from / to, c = -dot(d, n);
                const Real inner = s[1] != c * c ? 1 - s[1] : s[2], whole = 1 - s[0] * inner;
                const Real squared = s[3] != 1 - e * e * (1 - c * c) ? s[3] : whole;
                return row(squared < 0 ? vec3(0) : e * d + (e * c - std::sqrt(squared)) * n);
            })};
}

std::vector<Steps> joined(std::vector<Steps> all, Steps one) {
    all.push_back(std::move(one));
    return all;
}

}  // namespace

std::vector<Steps> steps_of_rays(const std::string& fragment) {
    if (fragment == "camera_ray") return of_camera();
    if (fragment == "hit_sphere") return joined(of_sphere(), of_sphere_vectors());
    if (fragment == "hit_triangle") return joined(of_triangle(), of_triangle_vectors());
    if (fragment == "hit_quad") return joined(of_quad(), of_quad_vectors());
    if (fragment == "mirror_direction") return of_mirror();
    if (fragment == "refracted_direction") {
        std::vector<Steps> all = of_refraction();
        for (const Steps& one : of_refraction()) all.push_back(normalised(one));
        return all;
    }
    return {};
}

}  // namespace grade
