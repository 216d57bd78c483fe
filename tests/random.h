#pragma once

#include <random>
#include <sstream>
#include <string>

#include "rt/math.h"

/// Random cases for properties, the same in each run.
struct Random {
    std::mt19937_64 engine;

    explicit Random(unsigned seed) : engine(seed) {}

    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine); }
    double number() { return between(0, 1); }

    /// Every order of magnitude alike.
    double scale(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

    int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(engine); }

    /// Of the unit square.
    rt::vec2 point() {
        const double x = number();
        const double y = number();
        return {x, y};
    }

    /// Of the cube -1 < x, y, z < 1.
    rt::vec3 in_cube() {
        const double x = between(-1, 1);
        const double y = between(-1, 1);
        const double z = between(-1, 1);
        return {x, y, z};
    }

    /// A unit vector, all alike.
    rt::vec3 direction() {
        for (;;) {
            const rt::vec3 v = in_cube();
            const double squared = dot(v, v);
            if (squared > 0.01 && squared < 1) return v / std::sqrt(squared);
        }
    }

    /// Every direction alike, and every order of magnitude.
    rt::vec3 vector(double low, double high) {
        const double length = scale(low, high);
        return length * direction();
    }

    /// A unit vector with v . n > least.
    rt::vec3 direction_about(rt::vec3 n, double least = 0.01) {
        for (;;) {
            const rt::vec3 v = direction();
            if (dot(v, n) > least) return v;
        }
    }
};

inline std::string text(rt::vec2 v) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << v.x << ", " << v.y << ")";
    return out.str();
}

inline std::string text(rt::vec3 v) {
    std::ostringstream out;
    out.precision(17);
    out << "(" << v.x << ", " << v.y << ", " << v.z << ")";
    return out.str();
}
