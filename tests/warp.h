#pragma once

#include <algorithm>
#include <vector>

#include "checks/kit/warp.h"
#include "random.h"
#include "statistics/tests.h"

/// Ways to look at a map of the unit square; the angle of a point is the checks' own.
using grade::turn;

/// The mean of f over the centres of n x n cells: the integral of f(u) over the unit square.
template <class F>
auto square_mean(int n, F f) {
    auto sum = 0.0 * f(rt::vec2(0.5));
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) sum += f(rt::vec2((i + 0.5) / n, (j + 0.5) / n));
    return sum / (double(n) * n);
}

/// By how much a map of the square to directions or points of space stretches areas at u. Where random points of the
/// square are mapped, their density there is the reciprocal.
template <class Map>
double area_stretch(Map map, rt::vec2 u) {
    const double h = 1e-5;
    const rt::vec3 du = (map(u + rt::vec2(h, 0)) - map(u - rt::vec2(h, 0))) / (2 * h);
    const rt::vec3 dv = (map(u + rt::vec2(0, h)) - map(u - rt::vec2(0, h))) / (2 * h);
    const rt::vec3 normal = cross(du, dv);
    return std::sqrt(dot(normal, normal));
}

/// How probable it is that points of the unit square are uniform, by counts in 16 x 16 cells.
template <class Sample>
double uniform_probability(Sample sample, int count = 100000) {
    std::vector<double> observed(256, 0), expected(256, count / 256.0);
    for (int i = 0; i < count; ++i) {
        const rt::vec2 p = sample();
        const int x = std::clamp(int(16 * p.x), 0, 15), y = std::clamp(int(16 * p.y), 0, 15);
        observed[std::size_t(16 * y + x)] += 1;
    }
    return grade::chi_squared_test(observed, expected).p;
}
