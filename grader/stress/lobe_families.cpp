#include "stress/family.h"

namespace grade::stress {

namespace {

using rt::DirectionSample, rt::Scattered, rt::vec2, rt::vec3;

/// How far the mean of values is from what it must be, where that is more than sampling on a grid explains.
double misplaced(double mean, double truth) { return std::abs(mean / truth - 1) < 0.03 ? 0 : rt::inf; }

/// Directions of a lobe, held against their own densities, and the lobe's width.
double lobe_exponent(double x, Generator&, const Asker& ask) {
    const Rows out = ask.probe("phong_lobe", rows_at(grid(24), [=](vec2 u) { return row(x, u); }));
    double worst = 0, squares = 0;
    for (const Row& each : out) {
        const auto [d, density] = from_row<DirectionSample>(each);
        const long double s2 = (long double)d.x * d.x + (long double)d.y * d.y;
        const long double log_cosine = s2 < 0.5L ? std::log1p(-s2) / 2 : std::log((long double)d.z);
        const long double truth = (x + 1) / (2 * rt::pi) * std::exp(x * log_cosine);
        worst = worse_error(worst, double(std::abs(density / truth - 1)));
        worst = worse_error(worst, std::abs(glm::length(d) - 1));
        squares += double(s2);
    }
    return worse_error(worst, misplaced(squares / double(out.size()), 2 / (x + 3)));
}

/// Directions towards a sphere at a distance of x radii.
double cone_angle(double x, Generator&, const Asker& ask) {
    const double sine = 1 / x;
    const long double s = sine, m = s * s / (1 + std::sqrt(1 - s * s));  // 1 - cos
    const Rows out = ask.probe("sphere_cone", rows_at(grid(24), [=](vec2 u) { return row(sine, u); }));
    double worst = 0, squares = 0;
    for (const Row& each : out) {
        const auto [d, density] = from_row<DirectionSample>(each);
        worst = worse_error(worst, double(std::abs(density * 2 * (long double)rt::pi * m - 1)));
        worst = worse_error(worst, std::abs(glm::length(d) - 1));
        squares += d.x * d.x + d.y * d.y;
    }
    return worse_error(worst, misplaced(squares / double(out.size()), double(m - m * m / 3)));
}

/// A lobe of exponent x about the mirrored or refracted ray: its width, in the mean.
auto narrow(bool mirror) {
    return [=](double x, Generator& random, const Asker& ask) {
        const std::string fragment = mirror ? "glossy_reflection" : "translucency";
        const double eta = 1.5;
        double worst = 0;
        for (int i = 0; i < 4; ++i) {
            const vec3 n = direction(random), d = -tilted(random, n, 0.5);
            const double cosine = -dot(d, n), other = std::sqrt(1 - (1 - cosine * cosine) / (eta * eta));
            const vec3 axis = rt::unit(mirror ? d + 2 * cosine * n : d / eta + (cosine / eta - other) * n);
            const Rows out = ask.probe(fragment, rows_at(grid(24), [&](vec2 u) {
                                           return mirror ? row(d, n, x, u) : row(d, n, 1.0, eta, x, u);
                                       }));
            double sum = 0;
            for (const Row& each : out) {
                const auto [direction, weight] = from_row<Scattered>(each);
                if (!(rt::largest(weight) < 2)) return rt::inf;
                const vec3 off = direction - axis;
                sum += dot(off, off) / 2;  // 1 - cos
            }
            worst = worse_error(worst, std::abs(sum / double(out.size()) * (x + 2) - 1));
        }
        return worst;
    };
}

}  // namespace

std::vector<Family> lobe_families() {
    constexpr double u = rt::roundoff;
    return {Family("lobe_exponent", {"phong_lobe"}, "exponent of a lobe", "error of density or length",
                   {.tolerance = 1e-3, .bound = 1e-12, .decades = sweep(0, 20), .scored = {0, 4}}, lobe_exponent),
            Family("cone_angle", {"sphere_cone"}, "distance of a sphere / its radius", "error of density or length",
                   {.bound = 32 * u, .decades = sweep(0, 20), .scored = {0, 3}}, cone_angle),
            Family("glossy_exponent", {"glossy_reflection"}, "exponent of a lobe", "error of the lobe's width",
                   {.tolerance = 0.05, .bound = 0.05, .decades = sweep(2, 26), .scored = {2, 4}}, narrow(true)),
            Family("translucent_exponent", {"translucency"}, "exponent of a lobe", "error of the lobe's width",
                   {.tolerance = 0.05, .bound = 0.05, .decades = sweep(2, 26), .scored = {2, 4}}, narrow(false))};
}

}  // namespace grade::stress
