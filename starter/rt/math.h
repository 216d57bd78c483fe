#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <numbers>

/// Numbers and vectors. Everything is double: most of what goes wrong in a ray tracer is rounding.
namespace rt {

using Real = double;
using glm::cross;
using glm::dot;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using ivec2 = glm::ivec2;

/// Linear RGB: a radiance [W/(sr m2)], an irradiance [W/m2], a reflectance [1].
using Color = vec3;

constexpr Real inf = std::numeric_limits<Real>::infinity();
constexpr Real pi = std::numbers::pi;

/// Unit roundoff of a Real, 2^-53: the relative error of one operation.
constexpr Real roundoff = std::numeric_limits<Real>::epsilon() / 2;

/// The greatest number below 1.
constexpr Real below_one = 1 - roundoff;

/// sqrt(max(x, 0)): for an x that only rounding can have made negative.
inline Real safe_sqrt(Real x) { return std::sqrt(x > 0 ? x : 0); }

inline Real sqr(Real x) { return x * x; }

/// v / |v|. A zero vector stays zero.
inline vec3 unit(vec3 v) {
    const Real squared = dot(v, v);
    return v * (squared > 0 ? 1 / std::sqrt(squared) : 0);
}

/// (cos, sin) of a full circle's fraction: turn = 1/4 is the y axis. Without library calls, so that loops vectorise and
/// every machine gets the same bits; error below 2 roundoff.
///
/// turn  0 <= turn < 1
[[gnu::always_inline]] inline vec2 unit_circle(Real turn) {
    // The nearest quarter of the circle, and the angle from there, at most pi/4; then the series of sine and cosine.
    const Real quarter = std::floor(4 * turn + 0.5);
    const Real a = (turn - 0.25 * quarter) * (2 * pi), a2 = a * a;
    const Real sine =
        a * (1 + a2 * (-1.0 / 6 +
                       a2 * (1.0 / 120 +
                             a2 * (-1.0 / 5040 + a2 * (1.0 / 362880 +
                                                       a2 * (-1.0 / 39916800 + a2 * (1.0 / 6227020800 +
                                                                                     a2 * (-1.0 / 1307674368000))))))));
    const Real cosine =
        1 + a2 * (-1.0 / 2 +
                  a2 * (1.0 / 24 +
                        a2 * (-1.0 / 720 +
                              a2 * (1.0 / 40320 + a2 * (-1.0 / 3628800 + a2 * (1.0 / 479001600 +
                                                                               a2 * (-1.0 / 87178291200 +
                                                                                     a2 * (1.0 / 20922789888000))))))));
    const bool left = bool(quarter == 1) | bool(quarter == 2), below = bool(quarter == 2) | bool(quarter == 3);
    const bool swap = left != below;
    const Real x = swap ? sine : cosine, y = swap ? cosine : sine;
    return {left ? -x : x, below ? -y : y};
}

/// a b - c d with an error of two roundings of the result, where plain arithmetic may have no digit right.
///
/// Source: Cornea, Harrison, Tang, "Scientific Computing on Itanium-based Systems", 2002; Jeannerod, "A
/// Radix-Independent Error Analysis of the Cornea-Harrison-Tang Method", ACM TOMS 42(3), 2016.
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
    const Real ab = a * b, cd = c * d;
    return (ab - cd) + (std::fma(a, b, -ab) - std::fma(c, d, -cd));
}

/// v cross w, each coordinate to two roundings, also where v and w are almost parallel.
inline vec3 exact_cross(vec3 v, vec3 w) {
    return {difference_of_products(v.y, w.z, v.z, w.y), difference_of_products(v.z, w.x, v.x, w.z),
            difference_of_products(v.x, w.y, v.y, w.x)};
}

/// The largest of |x|, |y|, |z|.
inline Real largest(vec3 v) {
    const Real x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
    const Real xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/// Three unit vectors at right angles, x cross y = z.
struct Frame {
    vec3 x, y, z;

    /// A vector given in this frame, in the space of the axes.
    vec3 to_world(vec3 local) const { return local.x * x + local.y * y + local.z * z; }
};

/// A frame whose z axis is the unit vector n.
///
/// Source: Duff et al., "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017.
[[gnu::always_inline]] inline Frame frame_about(vec3 n) {
    const Real sign = n.z >= 0 ? 1.0 : -1.0;
    const Real a = -1 / (sign + n.z);
    const Real b = n.x * n.y * a;
    return {{1 + sign * n.x * n.x * a, sign * b, -sign * n.x}, {b, sign + n.y * n.y * a, -n.y}, n};
}

/// A sum whose error does not grow with the number of terms: what each addition loses is summed as well.
///
/// Source: Knuth, "The Art of Computer Programming", vol. 2, 3rd ed., section 4.2.2, theorem B.
struct Sum {
    Real total = 0, lost = 0;

    void add(Real x) {
        const Real next = total + x, added = next - total;
        lost += (total - (next - added)) + (x - added);
        total = next;
    }
    Real value() const { return total + lost; }
};

}  // namespace rt
