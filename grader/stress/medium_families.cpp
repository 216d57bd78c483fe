#include "asked/free_flight.h"
#include "asked/scatter_direction.h"
#include "stress/exact.h"
#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::DirectionSample, rt::vec2, rt::vec3;

/// Extinction x: the mean distance, and the shortest and longest ones.
double extinction(double x, Generator&, const Asker& ask) {
    constexpr int n = 1000;
    Rows rows;
    for (int i = 0; i < n; ++i) rows.push_back(row(x, (i + 0.5) / n));
    rows.push_back(row(x, almost_one));
    rows.push_back(row(x, 0.0));
    const Rows out = ask.probe("free_flight", rows);
    double sum = 0;
    for (const Row& each : out)
        if (!(each.at(0) >= 0 && each[0] < rt::inf)) return rt::inf;
    for (int i = 0; i < n; ++i) sum += out[std::size_t(i)][0];
    return std::abs(sum / n * x - 1);
}

/// Random numbers so near 0 and so near 1: -log of the number or of its complement, either way.
double short_flight(double x, Generator& random, const Asker& ask) {
    Rows rows;
    for (int i = 0; i < 100; ++i) {
        const double u = x * between(random, 0.5, 1);
        rows.push_back(row(2.0, i % 2 ? u : std::min(1 - u, almost_one)));
    }
    return worst_of<rt::free_flight>(ask, "free_flight", rows, [](double flight, double, double number) {
        const Exact u = number, t = Exact(flight) * 2;
        if (!(flight >= 0 && flight < rt::inf)) return rt::inf;
        const Exact one = -log(1 - u), other = -log(u);
        return double(std::min(Exact(abs(t - one) / one), Exact(abs(t - other) / other)));
    });
}

/// Scattering about a direction with 1 - g = x: the density at the angle that the direction has.
double forward(double x, Generator& random, const Asker& ask) {
    Rows rows;
    const double g = 1 - x;
    for (int i = 0; i < 300; ++i) rows.push_back(row(vec3(0, 0, 1), g, square(random)));
    const long double rest = 1 - (long double)g;  // as g is rounded
    return worst_of<rt::scatter_direction>(ask, "scatter_direction", rows, [=](const DirectionSample& sample) {
        const auto [d, density] = sample;
        const long double s2 = (long double)d.x * d.x + (long double)d.y * d.y;
        const long double off =
            d.z > 0 ? s2 / (1 + std::sqrt(std::max(0.0L, 1 - s2))) : 1 - (long double)d.z;  // 1 - cos
        const long double base = rest * rest + 2 * g * off;
        const long double truth = rest * (1 + (long double)g) / (4 * (long double)rt::pi * base * std::sqrt(base));
        return worse_error(double(std::abs(density / truth - 1)), std::abs(glm::length(d) - 1));
    });
}

/// Scattering that is all but even, g = x: densities at their angles, and the spread of the cosine.
double even(double x, Generator&, const Asker& ask) {
    double worst = 0;
    for (const double g : {x, -x, 0.0}) {
        if (g == 0 && x >= 1e-3) continue;
        const Rows out =
            ask.probe("scatter_direction", rows_at(grid(16), [=](vec2 u) { return row(vec3(0, 0, 1), g, u); }));
        double squares = 0;
        for (const Row& each : out) {
            const auto [d, density] = from_row<DirectionSample>(each);
            const double base = 1 + g * g - 2 * g * d.z;
            worst = worse_error(worst, std::abs(density * 4 * rt::pi * base * std::sqrt(base) / (1 - g * g) - 1));
            worst = worse_error(worst, std::abs(glm::length(d) - 1));
            squares += d.z * d.z / double(out.size());
        }
        if (!(std::abs(squares / ((1 + 2 * g * g) / 3) - 1) < 0.03)) return rt::inf;
    }
    return worst;
}

/// Scattering with 1 - g = x: the mean of 1 - cos is x.
double forward_mean(double x, Generator&, const Asker& ask) {
    const double g = 1 - x;
    double sum = 0;
    const Rows out =
        ask.probe("scatter_direction", rows_at(grid(40), [=](vec2 u) { return row(vec3(0, 0, 1), g, u); }));
    for (const Row& each : out) {
        const vec3 d = from_row<DirectionSample>(each).direction, off = d - vec3(0, 0, 1);
        // the few that turn back carry much of the mean: only the narrow part is measured
        sum += std::atan2(std::sqrt(dot(off, off)), x) / double(out.size());
    }
    return sum;
}

/// The part of a lobe within its own width, against that of a wide grid of exact inversions.
double forward_width(double x, Generator& random, const Asker& ask) {
    const double g = 1 - x;
    const long double rest = 1 - (long double)g;
    double truth = 0;
    const int n = 40;
    for (int i = 0; i < n; ++i) {
        // the inversion: 1 + g^2 - 2 g cos = ((1 - g^2) / (1 - g + 2 g u))^2
        const long double u = (i + 0.5L) / n, q = rest * (1 + (long double)g) / (rest + 2 * g * u);
        const long double off = (q * q - rest * rest) / (2 * (long double)g);
        truth += std::atan2(std::sqrt(2 * double(off)), x) / n;
    }
    return std::abs(forward_mean(x, random, ask) / truth - 1);
}

}  // namespace

std::vector<Family> medium_families() {
    constexpr double u = rt::roundoff;
    return {Family("extinction", {"free_flight"}, "extinction [1/m]", "error of the mean distance",
                   {.tolerance = 1e-2, .bound = 1e-2, .decades = sweep(-60, 60, 3)}, extinction),
            Family("short_flight", {"free_flight"}, "random number, from 0 and from 1", "relative error",
                   {.bound = 16 * u, .decades = sweep(-16, -1), .scored = {-3, -1}}, short_flight),
            Family("even_scattering", {"scatter_direction"}, "g", "error of density or length",
                   {.bound = 32 * u, .decades = sweep(-17, -1), .scored = {-3, -1}}, even),
            Family("forward_density", {"scatter_direction"}, "1 - g", "relative error of the density",
                   {.tolerance = 1e-4, .bound = 1e-8, .decades = sweep(-15, -1), .scored = {-2, -1}}, forward),
            Family("forward_width", {"scatter_direction"}, "1 - g", "relative error of the mean angle",
                   {.tolerance = 0.05, .bound = 0.05, .decades = sweep(-15, -1), .scored = {-2, -1}}, forward_width)};
}

}  // namespace grade::stress
