#include <algorithm>

#include "diagnosis/steps_made.h"

namespace grade {

namespace {

using namespace rt;

vec2 turned(Real phi) { return {std::cos(phi), std::sin(phi)}; }

DirectionSample lifted(Real sine, vec2 circle, Real cosine, Real density) {
    return {{sine * circle.x, sine * circle.y, cosine}, density};
}

/// A column's cells, as stratified_2d documents them.
struct OfColumn {
    Real columns, column, first, count;

    OfColumn(int i, int n, Real all) : columns(all) {
        column = std::floor(i * columns / n);
        first = std::ceil(column * n / columns);
        count = std::ceil((column + 1) * n / columns) - first;
    }
};

vec2 below(vec2 p) { return {std::min(p.x, below_one), std::min(p.y, below_one)}; }

std::vector<Steps> of_strata_2d() {
    return {
        steps(
            "x = left + u.x * width, y = bottom + u.y * height; left = first / n, width = count / n, bottom = row / "
            "count, height = 1 / count",
            "Real left; Real width; Real bottom; Real height; Real column / columns; Real 1 / columns; Real column; "
            "Real row; Real columns / n; Real row * columns / n; Real 1 / sqrt(n); Real column / sqrt(n)",
            +[](const int& i, const int& n, const vec2&) {
                const Real all = std::floor(std::sqrt(Real(n))), root = std::sqrt(Real(n));
                const OfColumn own(i, n, all);
                const Real row_of = i - own.first;
                return row(own.first / n, own.count / n, row_of / own.count, 1 / own.count, own.column / all, 1 / all,
                           own.column, row_of, all / n, row_of * all / n, 1 / root, own.column / root);
            },
            +[](const double* s, const int&, const int&, const vec2& u) {
                return row(below({s[0] + u.x * s[1], s[2] + u.y * s[3]}));
            }),
        steps(
            "",
            "bool cells i % c and i / c with c = floor(sqrt(n)), which fill the square for a square n alone; bool "
            "cells i % c and i / c with c = ceil(sqrt(n)), which leave cells empty where n is no square; bool "
            "ceil(sqrt(n)) columns in place of floor(sqrt(n)); bool (i % c + u.x / c, i / c + u.y / c): the cell is "
            "not divided by c; bool columns of n / c cells each, of whole numbers; bool columns of n / c cells each, "
            "no whole number; bool sqrt(n) columns, which is no whole number: not rounded down; bool one column more; "
            "bool one column less; bool a grid of floor(sqrt(n)) columns and ceil(n / columns) rows, of which some "
            "cells are left empty; bool a grid of ceil(sqrt(n)) columns and ceil(n / columns) rows, of which some "
            "cells are left empty; bool a grid of round(sqrt(n)) columns and ceil(n / columns) rows, of which some "
            "cells are left empty; bool a strip of 1 / n for each cell, as high as the square; bool x and y both in "
            "the strip of cell i: cells along the diagonal alone; bool u alone, whichever cell it is; "
            "bool cells i / c and i % c with c = floor(sqrt(n)), which fill the square for a square n alone; bool the "
            "column divided by n, not by the number of columns",
            +[](const int&, const int&, const vec2&) { return Row(17); },
            +[](const double* s, const int& i, const int& n, const vec2& u) {
                if (n < 1) return row(u);
                const Real root = std::sqrt(Real(n)), low = std::floor(root), high = std::ceil(root);
                if (s[9] != 0 || s[10] != 0 || s[11] != 0) {
                    const int c = int(s[9] != 0 ? low : s[10] != 0 ? high : std::round(root));
                    return row(below(vec2((i % c + u.x) / c, (i / c + u.y) / ((n + c - 1) / c))));
                }
                if (s[12] != 0) return row(below(vec2((i + u.x) / n, u.y)));
                if (s[13] != 0) return row(below((Real(i) + u) / Real(n)));
                if (s[14] != 0) return row(u);
                if (s[15] != 0) return row(below((vec2(i / int(low), i % int(low)) + u) / low));
                if (s[0] != 0 || s[1] != 0 || s[3] != 0) {
                    const int c = int(s[1] != 0 ? high : low);
                    if (s[3] != 0) return row(vec2(i % c, i / c) + u / Real(c));
                    return row(vec2((i % c + u.x) / c, (i / c + u.y) / c));
                }
                if (s[4] != 0 || s[5] != 0) {
                    const Real rows = s[4] != 0 ? std::floor(n / low) : n / low, column = std::floor(i / rows);
                    return row(below(vec2((column + u.x) / low, (i - column * rows + u.y) / rows)));
                }
                if (s[16] != 0) {
                    const OfColumn own(i, n, low);
                    return row(below(vec2((own.column + u.x) / n, (i - own.first + u.y) / own.count)));
                }
                const Real whole = (s[2] != 0 ? high : low) + (s[7] != 0) - (s[8] != 0);
                const OfColumn own(i, n, s[6] != 0 ? root : std::max(1.0, whole));
                return row(below(vec2((own.first + u.x * own.count) / n, (i - own.first + u.y) / own.count)));
            })};
}

std::vector<Steps> of_disk() {
    return {steps(
        "r * (cos(phi), sin(phi)), phi = 2 * pi * u.y",
        "Real r; Real cos(phi); Real sin(phi); Real phi; bool the "
        "square 2 * u - 1, whose corners lie outside of the disk; bool the square 2 * u - 1, of which what lies "
        "outside of the disk is put onto its border",
        +[](const vec2& u) {
            const vec2 circle = turned(2 * pi * u.y);
            return row(std::sqrt(u.x), circle.x, circle.y, 2 * pi * u.y, false, false);
        },
        +[](const double* s, const vec2& u) {
            const vec2 square = 2.0 * u - vec2(1);
            if (s[4] != 0 || s[5] != 0)
                return row(DiskSample{s[5] != 0 ? square / std::max(1.0, length(square)) : square, 1 / pi});
            const vec2 circle = s[3] != 2 * pi * u.y ? turned(s[3]) : vec2(s[1], s[2]);
            return row(DiskSample{s[0] * circle, 1 / pi});
        })};
}

constexpr const char* raised_names = "Real sin(theta); Real cos(theta); Real cos(phi); Real sin(phi); Real phi";
constexpr const char* raised_formula = "(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)), phi = 2 * pi * u.y";

Row steps_of_raised(Real cosine, Real turn) {
    const vec2 circle = turned(2 * pi * turn);
    return row(std::sqrt(1 - cosine * cosine), cosine, circle.x, circle.y, 2 * pi * turn);
}

vec3 raised_by_steps(const double* s, Real turn) {
    const vec2 circle = s[4] != 2 * pi * turn ? turned(s[4]) : vec2(s[2], s[3]);
    return lifted(s[0], circle, s[1], 0).direction;
}

std::vector<Steps> of_hemisphere() {
    return {
        steps(
            raised_formula, raised_names, +[](const vec2& u) { return steps_of_raised(std::sqrt(1 - u.x), u.y); },
            +[](const double* s, const vec2& u) {
                return row(DirectionSample{raised_by_steps(s, u.y), s[1] / pi});
            }),
        steps(
            "z = sqrt(1 - u.x), density = cos(theta) / pi",
            "Real 1 - u.x; Real z; Real cos(theta); bool theta = u.x * pi / 2, uniform in the angle; bool theta = u.x "
            "* pi, on the whole sphere; bool u.x as the cosine: directions uniform on the hemisphere; bool 1 - u.x as "
            "the cosine: "
            "directions uniform on the hemisphere; bool 1 / (2 * pi) as density, which is that of uniform directions",
            +[](const vec2& u) {
                Row taken = row(1 - u.x, std::sqrt(1 - u.x), std::sqrt(1 - u.x));
                taken.resize(8);
                return taken;
            },
            +[](const double* s, const vec2& u) {
                const auto density = [s](Real c) { return s[7] != 0 ? 1 / (2 * pi) : c / pi; };
                if (s[3] != 0 || s[4] != 0 || s[5] != 0 || s[6] != 0) {
                    const Real c = s[5] != 0 ? u.x : s[6] != 0 ? 1 - u.x : std::cos(u.x * pi / (s[3] != 0 ? 2 : 1));
                    return row(lifted(std::sqrt(1 - c * c), turned(2 * pi * u.y), c, density(c)));
                }
                const bool both = s[0] != 1 - u.x;
                const Real z = std::sqrt(s[0]);
                return row(lifted(std::sqrt(u.x), turned(2 * pi * u.y), both ? z : s[1], density(both ? z : s[2])));
            })};
}

std::vector<Steps> of_lobe() {
    return {
        steps(
            raised_formula, raised_names,
            +[](const Real& n, const vec2& u) { return steps_of_raised(std::pow(u.x, 1 / (n + 1)), u.y); },
            +[](const double* s, const Real& n, const vec2& u) {
                return row(DirectionSample{raised_by_steps(s, u.y), (n + 1) / (2 * pi) * std::pow(s[1], n)});
            }),
        steps(
            raised_formula, raised_names,
            +[](const Real& n, const vec2& u) { return steps_of_raised(std::pow(u.x, 1 / (n + 1)), u.y); },
            +[](const double* s, const Real& n, const vec2& u) {
                const Real density = (n + 1) / (2 * pi) * std::pow(u.x, n / (n + 1));
                return row(DirectionSample{raised_by_steps(s, u.y), density});
            }),
        steps(
            "cos(alpha) = u.x^(1 / (n + 1))", "Real n + 1; Real 1 / (n + 1)",
            +[](const Real& n, const vec2&) { return row(n + 1, 1 / (n + 1)); },
            +[](const double* s, const Real& n, const vec2& u) {
                const Real c = std::pow(u.x, s[0] != n + 1 ? 1 / s[0] : s[1]);
                return row(lifted(std::sqrt(1 - c * c), turned(2 * pi * u.y), c, (n + 1) / (2 * pi) * std::pow(c, n)));
            }),
        steps(
            "density = (n + 1) / (2 * pi) * cos(alpha)^n", "Real n + 1; Real the power n; Real 2 * pi",
            +[](const Real& n, const vec2&) { return row(n + 1, n, 2 * pi); },
            +[](const double* s, const Real& n, const vec2& u) {
                const Real c = std::pow(u.x, 1 / (n + 1));
                return row(lifted(std::sqrt(1 - c * c), turned(2 * pi * u.y), c, s[0] / s[2] * std::pow(c, s[1])));
            })};
}

std::vector<Steps> of_cone() {
    return {
        steps(
            raised_formula, raised_names,
            +[](const Real& sine, const vec2& u) {
                return steps_of_raised(1 - u.x * (1 - std::sqrt(1 - sine * sine)), u.y);
            },
            +[](const double* s, const Real& sine, const vec2& u) {
                return row(DirectionSample{raised_by_steps(s, u.y), 1 / (2 * pi * (1 - std::sqrt(1 - sine * sine)))});
            }),
        steps(
            "cos(theta) = 1 - u.x * m, m = 1 - cos(theta_max), density = 1 / (2 * pi * m)",
            "Real cos(theta_max); Real m; Real m in the density; bool u.x * cos(theta_max) as the cosine: also "
            "directions outside of the cone; bool cos(u.x * theta_max) as the cosine: uniform in the angle; bool 1 - "
            "u.x * cos(theta_max) as the cosine; bool a uniform point of a disk as wide as the cone, 1 above its tip: "
            "directions that are not uniform",
            +[](const Real& sine, const vec2&) {
                const Real c = std::sqrt(1 - sine * sine);
                return row(c, 1 - c, 1 - c, false, false, false, false);
            },
            +[](const double* s, const Real& sine, const vec2& u) {
                const Real all = std::sqrt(1 - sine * sine);
                const bool other = s[0] != all;
                const Real m = other ? 1 - s[0] : s[1];
                const Real c = s[3] != 0   ? u.x * all
                               : s[4] != 0 ? std::cos(u.x * std::asin(sine))
                               : s[5] != 0 ? 1 - u.x * all
                               : s[6] != 0 ? 1 / std::sqrt(1 + u.x * sqr(sine / all))
                                           : 1 - u.x * m;
                return row(
                    lifted(std::sqrt(1 - c * c), turned(2 * pi * u.y), c, 1 / (2 * pi * (other ? 1 - s[0] : s[2]))));
            })};
}

std::vector<Steps> of_scattering() {
    const auto take = +[](const vec3&, const Real& g, const vec2& u) {
        const Real s = 2 * u.x - 1;
        const Real c = (2 * s + g * (3 + s * s) + 2 * g * g * s + g * g * g * (s * s - 1)) / (2 * sqr(1 + g * s));
        return row(c, c, 2 * pi * u.y, 1 - g * g, 1 + g * g - 2 * g * c, 1.5, false, false,
                   std::sqrt(std::max(0.0, 1 - c * c)));
    };
    return {steps(
                "density = (1 - g * g) / (4 * pi * pow(1 + g * g - 2 * g * c, 1.5))",
                "Real c; Real c in the density; Real phi; Real 1 - g * g; Real 1 + g * g - 2 * g * c; Real 1.5; bool "
                "directions uniform on the sphere, whatever g is, and the density that these would have with g; bool "
                "directions uniform on the sphere, whatever g is; Real sin(theta)",
                take,
                +[](const double* s, const vec3& d, const Real& g, const vec2& u) {
                    const bool is_uniform = s[6] != 0 || s[7] != 0;
                    const Real c = is_uniform ? 2 * u.x - 1 : s[0];
                    // of the right c, the sine that is given
                    const Real sine = !is_uniform && s[1] == c ? s[8] : std::sqrt(std::max(0.0, 1 - c * c));
                    const Real usual = 1 + g * g - 2 * g * c;
                    const Real base = s[6] != 0                           ? usual
                                      : s[1] != s[0]                      ? 1 + g * g - 2 * g * s[1]
                                      : std::abs(s[4] / usual - 1) < 1e-9 ? usual
                                                                          : s[4];
                    return row(DirectionSample{frame_about(d).to_world(lifted(sine, turned(s[2]), c, 0).direction),
                                               s[3] / (4 * pi * std::pow(base, s[5]))});
                }),
            steps(
                "c = (1 + g * g - q * q) / (2 * g), q = (1 - g * g) / (1 - g + 2 * g * u.x)", "Real q * q; Real q",
                +[](const vec3&, const Real& g, const vec2& u) {
                    const Real q = (1 - g * g) / (1 - g + 2 * g * u.x);
                    return row(q * q, q);
                },
                +[](const double* s, const vec3& d, const Real& g, const vec2& u) {
                    const Real c =
                        std::abs(g) < 1e-3 ? 2 * u.x - 1 : std::clamp((1 + g * g - s[0]) / (2 * g), -1.0, 1.0);
                    const vec3 about_z = lifted(std::sqrt(1 - c * c), turned(2 * pi * u.y), c, 0).direction;
                    return row(DirectionSample{frame_about(d).to_world(about_z),
                                               (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * c, 1.5))});
                })};
}

}  // namespace

std::vector<Steps> steps_of_warps(const std::string& fragment) {
    if (fragment == "stratified_2d") return of_strata_2d();
    if (fragment == "uniform_disk") return of_disk();
    if (fragment == "cosine_hemisphere") return of_hemisphere();
    if (fragment == "phong_lobe") return of_lobe();
    if (fragment == "sphere_cone") return of_cone();
    if (fragment == "scatter_direction") return of_scattering();
    return {};
}

}  // namespace grade
