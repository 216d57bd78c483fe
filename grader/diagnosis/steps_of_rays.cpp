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
            "Real e^2; Real c^2; Real 1 - c^2; Real 1 - e^2 * (1 - c^2); Real (1 - c)^2",
            +[](const vec3& d, const vec3& n, const Real& from, const Real& to) {
                const Real e = from / to, c = -dot(d, n);
                return row(e * e, c * c, 1 - c * c, 1 - e * e * (1 - c * c), sqr(1 - c));
            },
            +[](const double* s, const vec3& d, const vec3& n, const Real& from, const Real& to) {
                const Real e = from / to, c = -dot(d, n);
                const Real inner = s[1] != c * c ? 1 - s[1] : s[2], whole = 1 - s[0] * inner;
                const Real squared = s[3] != 1 - e * e * (1 - c * c) ? s[3] : whole;
                return row(squared < 0 ? vec3(0) : e * d + (e * c - std::sqrt(squared)) * n);
            })};
}

}  // namespace

std::vector<Steps> steps_of_rays(const std::string& fragment) {
    if (fragment == "camera_ray") return of_camera();
    if (fragment == "mirror_direction") return of_mirror();
    if (fragment == "refracted_direction") {
        std::vector<Steps> all = of_refraction();
        for (const Steps& one : of_refraction()) all.push_back(normalised(one));
        return all;
    }
    return {};
}

}  // namespace grade
