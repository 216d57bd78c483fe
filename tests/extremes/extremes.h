#pragma once

#include <cmath>
#include <cstdlib>
#include <string>

#include "catch.h"
#include "random.h"
#include "rt/world.h"

/// What the tests of extremes/README.md share.

/// Whether the long counts were asked for: PENUMBRA_LONG=1.
inline bool long_run() {
    const char* value = std::getenv("PENUMBRA_LONG");
    return value && *value && *value != '0';
}

inline std::int64_t count_of(double in_check, double in_long_run) {
    return std::int64_t(long_run() ? in_long_run : in_check);
}

/// A figure of the README's table: the greatest value found, which must not be above the bound. With PENUMBRA_FIGURES=1
/// the figures are printed when the tests end.
void figure(int number, const std::string& what, double value, double bound);

/// The greatest of the values seen; a NaN is greater than any number.
struct Greatest {
    double value = 0;
    void see(double x) { value = x > value || x != x ? (value != value ? value : x) : value; }
};

using Long = glm::tvec3<long double>;

inline long double exact_dot(Long a, Long b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline long double exact_length(Long v) { return std::sqrt(exact_dot(v, v)); }

/// 2^k for a whole k.
inline double power_of_two(int k) { return std::ldexp(1.0, k); }

/// A scene with one plain material, and no light.
inline rt::Scene plain_scene() {
    rt::Scene scene;
    scene.materials.resize(1);
    scene.materials[0].albedo = rt::Color(0.5);
    return scene;
}

inline rt::World world_of(rt::Shape shape) {
    rt::Scene scene = plain_scene();
    scene.shapes.push_back(shape);
    return rt::make_world(scene);
}
