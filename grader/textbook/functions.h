#pragma once

#include <algorithm>
#include <cmath>

#include "rt/math.h"

/// What is done to a number or a vector by mistake.
namespace grade {

using rt::vec3;

struct Function {
    const char* words;  // {} is the argument
    double cost;
    double (*value)(double);
    const char* usually = "";  // what that is in most code
};

inline constexpr Function scalar_functions[] = {
    {"-{}", 1, [](double x) { return -x; }},
    {"2 * {}", 1.1, [](double x) { return 2 * x; }},
    {"{} / 2", 1.1, [](double x) { return x / 2; }},
    {"{0} * {0}", 1.2, [](double x) { return x * x; }, ": is a square root missing, or does it count twice?"},
    {"sqrt({})", 1.2, [](double x) { return std::sqrt(x); }, ": is a square missing, or a root too many?"},
    {"1 / {}", 1.2, [](double x) { return 1 / x; }},
    {"1 - {}", 1.2, [](double x) { return 1 - x; }},
    {"{} + 1", 1.2, [](double x) { return x + 1; }},
    {"{} - 1", 1.2, [](double x) { return x - 1; }},
    {"abs({})", 1.2, [](double x) { return std::abs(x); }},
    {"max({}, 0)", 1.3, [](double x) { return std::max(x, 0.0); }},
    {"min({}, 1)", 1.3, [](double x) { return std::min(x, 1.0); }},
    {"max({}, 1)", 1.4, [](double x) { return std::max(x, 1.0); }},
    {"0", 1.25, [](double) { return 0.0; }},
    {"1", 1.25, [](double) { return 1.0; }},
    {"0.5", 1.4, [](double) { return 0.5; }},
    {"inf", 1.6, [](double) { return rt::inf; }},
    {"{} * 180 / pi", 1.5, [](double x) { return x * 180 / rt::pi; }, ": angles are in radians"},
    {"{} * pi / 180", 1.5, [](double x) { return x * rt::pi / 180; }, ": it is in radians already"},
    {"tan({})", 1.5, [](double x) { return std::tan(x); }},
    {"atan({})", 1.6, [](double x) { return std::atan(x); }},
    {"sin({})", 1.6, [](double x) { return std::sin(x); }},
    {"cos({})", 1.6, [](double x) { return std::cos(x); }},
    {"asin({})", 1.6, [](double x) { return std::asin(x); }},
    {"{} / (2 * pi)", 1.5, [](double x) { return x / (2 * rt::pi); }},
    {"2 * pi * {}", 1.5, [](double x) { return 2 * rt::pi * x; }},
    {"{} / pi", 1.6, [](double x) { return x / rt::pi; }},
    {"pi * {}", 1.6, [](double x) { return x * rt::pi; }},
    {"{} / 4", 1.7, [](double x) { return x / 4; }},
    {"4 * {}", 1.7, [](double x) { return 4 * x; }},
    {"3 * {} / 4", 1.9, [](double x) { return 0.75 * x; }},
    {"floor({})", 1.6, [](double x) { return std::floor(x); }},
    {"round({})", 1.6, [](double x) { return std::round(x); }},
    {"{} + 0.5", 1.6, [](double x) { return x + 0.5; }},
    {"{} - 0.5", 1.6, [](double x) { return x - 0.5; }},
    {"{} + 2", 1.7, [](double x) { return x + 2; }},
    {"{} - 2", 1.7, [](double x) { return x - 2; }},
    {"2 * {} - 1", 1.7, [](double x) { return 2 * x - 1; }},
    {"(1 + {}) / 2", 1.7, [](double x) { return (1 + x) / 2; }},
    {"sqrt(sqrt({}))", 1.9, [](double x) { return std::sqrt(std::sqrt(x)); }},
    {"sqrt(1 - {0} * {0})", 1.8, [](double x) { return std::sqrt(1 - x * x); }},
    {"1 - {0} * {0}", 1.9, [](double x) { return 1 - x * x; }},
    {"cbrt({})", 1.8, [](double x) { return std::cbrt(x); }},
    {"pow({}, 2.0 / 3)", 1.9, [](double x) { return std::pow(x, 2.0 / 3); }},
    {"pow({}, 3)", 1.9, [](double x) { return x * x * x; }},
    {"pow({}, 1.5)", 2, [](double x) { return std::pow(x, 1.5); }},
    {"pow({}, 4)", 2, [](double x) { return x * x * x * x; }},
};

struct TwoScalars {
    const char* words;
    double cost;
    double (*value)(double, double);
};

/// Of a small or a large constant, such as a tolerance or a limit.
inline constexpr Function tolerance_functions[] = {
    {"0", 0.75, [](double) { return 0.0; }},
    {"{} / 1e12", 0.76, [](double x) { return x / 1e12; }, ": a tolerance must be small beside what is compared"},
    {"{} / 1e9", 0.77, [](double x) { return x / 1e9; }, ": a tolerance must be small beside what is compared"},
    {"{} / 1e8", 0.78, [](double x) { return x / 1e8; }, ": a tolerance must be small beside what is compared"},
    {"{} / 1e6", 0.79, [](double x) { return x / 1e6; }, ": a tolerance must be small beside what is compared"},
    {"{} / 1e4", 0.8, [](double x) { return x / 1e4; }, ": a tolerance must be small beside what is compared"},
    {"{} / 1e3", 0.81, [](double x) { return x / 1e3; }, ": a tolerance must be small beside what is compared"},
    {"10 * {}", 1.15, [](double x) { return 10 * x; }},
    {"100 * {}", 1.15, [](double x) { return 100 * x; }},
    {"1e3 * {}", 1.15, [](double x) { return 1e3 * x; }},
};
inline constexpr TwoScalars relative_tolerances[] = {
    {"1e-9 * {1}", 1.1, [](double, double y) { return 1e-9 * y; }},
};
inline constexpr Function limit_functions[] = {
    {"1e3 * {}", 1.05, [](double x) { return 1e3 * x; }, ": values beyond it are promised"},
    {"1e6 * {}", 1.05, [](double x) { return 1e6 * x; }, ": values beyond it are promised"},
    {"1e9 * {}", 1.05, [](double x) { return 1e9 * x; }, ": values beyond it are promised"},
};

/// Of a constant close to 1.
inline constexpr Function share_functions[] = {
    {"1", 1.05, [](double) { return 1.0; }, ": values up to 1 are promised"},
    {"1 + 1e-9", 1.1, [](double) { return 1 + 1e-9; }, ": a tolerance must be small"},
};

/// Of both coordinates of a pair.
inline constexpr Function pair_functions[] = {
    {"{}", 1.15, [](double x) { return x; }},
    {"{} + 1", 1.4, [](double x) { return x + 1; }},
    {"2 * {} - 1", 1.5, [](double x) { return 2 * x - 1; }},
    {"{} + 0.5", 1.3, [](double x) { return x + 0.5; }},
    {"{} - 0.5", 1.6, [](double x) { return x - 0.5; }},
    {"(1 + {}) / 2", 1.6, [](double x) { return (1 + x) / 2; }},
    {"{} / 2", 1.7, [](double x) { return x / 2; }},
    {"2 * {}", 1.7, [](double x) { return 2 * x; }},
    {"{0} * {0}", 1.8, [](double x) { return x * x; }},
    {"sqrt({})", 1.8, [](double x) { return std::sqrt(x); }},
    {"floor({})", 1.6, [](double x) { return std::floor(x); }},
    {"floor({}) + 0.5", 1.6, [](double x) { return std::floor(x) + 0.5; }},
    {"(0.5, 0.5)", 1.5, [](double) { return 0.5; }},
    {"(0, 0)", 1.5, [](double) { return 0.0; }},
};

inline constexpr TwoScalars of_two_scalars[] = {
    {"{1}", 1.5, [](double, double y) { return y; }},
    {"{0} * {1}", 1.9, [](double x, double y) { return x * y; }},
    {"{0} / {1}", 1.9, [](double x, double y) { return x / y; }},
    {"{1} / {0}", 2, [](double x, double y) { return y / x; }},
    {"{0} - {1}", 1.9, [](double x, double y) { return x - y; }},
    {"{0} + {1}", 1.9, [](double x, double y) { return x + y; }},
    {"1 - {1}", 1.9, [](double, double y) { return 1 - y; }},
    {"max({0}, {1})", 2.1, [](double x, double y) { return std::max(x, y); }},
    {"min({0}, {1})", 2.1, [](double x, double y) { return std::min(x, y); }},
};

struct VectorFunction {
    const char* words;
    double cost;
    vec3 (*value)(vec3);
};

inline constexpr VectorFunction vector_functions[] = {
    {"-{}", 1, [](vec3 v) { return -v; }},
    {"unit({})", 1.1, [](vec3 v) { return rt::unit(v); }},
    {"2 * {}", 1.2, [](vec3 v) { return 2.0 * v; }},
    {"{} / 2", 1.2, [](vec3 v) { return 0.5 * v; }},
    {"(0, 0, 0)", 1.2, [](vec3) { return vec3(0); }},
    {"(0, 0, 1)", 1.4, [](vec3) { return vec3(0, 0, 1); }},
    {"(0, 1, 0)", 1.4, [](vec3) { return vec3(0, 1, 0); }},
    {"(1, 0, 0)", 1.5, [](vec3) { return vec3(1, 0, 0); }},
    {"{0} / |{0}|^2", 1.8, [](vec3 v) { return v / rt::dot(v, v); }},
    {"{0} * |{0}|", 1.8, [](vec3 v) { return v * glm::length(v); }},
    {"{0} with x and y exchanged", 1.5, [](vec3 v) { return vec3(v.y, v.x, v.z); }},
    {"{0} with y and z exchanged", 1.5, [](vec3 v) { return vec3(v.x, v.z, v.y); }},
    {"{0} with x and z exchanged", 1.6, [](vec3 v) { return vec3(v.z, v.y, v.x); }},
    {"{0} with x = 0", 1.5, [](vec3 v) { return vec3(0, v.y, v.z); }},
    {"{0} with y = 0", 1.5, [](vec3 v) { return vec3(v.x, 0, v.z); }},
    {"{0} with z = 0", 1.5, [](vec3 v) { return vec3(v.x, v.y, 0); }},
    {"{0} with x negated", 1.6, [](vec3 v) { return vec3(-v.x, v.y, v.z); }},
    {"{0} with y negated", 1.6, [](vec3 v) { return vec3(v.x, -v.y, v.z); }},
    {"{0} with z negated", 1.6, [](vec3 v) { return vec3(v.x, v.y, -v.z); }},
    {"(|{0}|, |{0}|, |{0}|)", 1.7, [](vec3 v) { return vec3(glm::length(v)); }},
    {"(|x|, |y|, |z|) of {0}", 1.8, [](vec3 v) { return glm::abs(v); }},
};

inline constexpr VectorFunction color_functions[] = {
    {"{} / pi", 1.1, [](vec3 c) { return c / rt::pi; }},
    {"pi * {}", 1.1, [](vec3 c) { return c * rt::pi; }},
    {"2 * {}", 1.2, [](vec3 c) { return 2.0 * c; }},
    {"{} / 2", 1.2, [](vec3 c) { return 0.5 * c; }},
    {"{0} * {0}", 1.2, [](vec3 c) { return c * c; }},
    {"sqrt({})", 1.3, [](vec3 c) { return glm::sqrt(c); }},
    {"(0, 0, 0)", 1.2, [](vec3) { return vec3(0); }},
    {"(1, 1, 1)", 1.3, [](vec3) { return vec3(1); }},
    {"1 - {}", 1.4, [](vec3 c) { return 1.0 - c; }},
    {"min({}, 1)", 1.3, [](vec3 c) { return glm::min(c, vec3(1)); }},
    {"{0}.x in all channels", 1.3, [](vec3 c) { return vec3(c.x); }},
    {"{0}.y in all channels", 1.4, [](vec3 c) { return vec3(c.y); }},
    {"{0}.z in all channels", 1.4, [](vec3 c) { return vec3(c.z); }},
    {"{0} with red and green exchanged", 1.4, [](vec3 c) { return vec3(c.y, c.x, c.z); }},
    {"{0} with green and blue exchanged", 1.4, [](vec3 c) { return vec3(c.x, c.z, c.y); }},
    {"{0} with red and blue exchanged", 1.4, [](vec3 c) { return vec3(c.z, c.y, c.x); }},
    {"{0} with green for blue", 1.5, [](vec3 c) { return vec3(c.x, c.y, c.y); }},
    {"{0} with red for blue", 1.5, [](vec3 c) { return vec3(c.x, c.y, c.x); }},
    {"{0} with red for green", 1.5, [](vec3 c) { return vec3(c.x, c.x, c.z); }},
    {"{0} with blue for green", 1.5, [](vec3 c) { return vec3(c.x, c.z, c.z); }},
    {"{0} with green for red", 1.5, [](vec3 c) { return vec3(c.y, c.y, c.z); }},
    {"{0} with blue for red", 1.5, [](vec3 c) { return vec3(c.z, c.y, c.z); }},
    {"the mean of {}'s channels", 1.5, [](vec3 c) { return vec3((c.x + c.y + c.z) / 3); }},
    {"pow({}, 1 / 2.2)", 1.7, [](vec3 c) { return glm::pow(c, vec3(1 / 2.2)); }},
    {"pow({}, 2.2)", 1.7, [](vec3 c) { return glm::pow(c, vec3(2.2)); }},
};

/// A vector times a number, or over one: what it is multiplied with.
inline constexpr TwoScalars vector_scales[] = {
    {"{0} * {1}", 1.8, [](double, double y) { return y; }},
    {"{0} / {1}", 1.8, [](double, double y) { return 1 / y; }},
};

struct TwoVectors {
    const char* words;
    double cost;
    vec3 (*value)(vec3, vec3);
};

inline constexpr TwoVectors of_two_vectors[] = {
    {"{1}", 1.4, [](vec3, vec3 w) { return w; }},
    {"-{1}", 1.6, [](vec3, vec3 w) { return -w; }},
    {"{0} + {1}", 1.7, [](vec3 v, vec3 w) { return v + w; }},
    {"{0} - {1}", 1.7, [](vec3 v, vec3 w) { return v - w; }},
    {"unit({0} + {1})", 1.7, [](vec3 v, vec3 w) { return rt::unit(v + w); }},
    {"2 * dot({0}, {1}) * {1} - {0}", 1.7, [](vec3 v, vec3 w) { return 2 * rt::dot(v, w) * w - v; }},
    {"{0} - 2 * dot({0}, {1}) * {1}", 1.8, [](vec3 v, vec3 w) { return v - 2 * rt::dot(v, w) * w; }},
    {"{0}, turned to the side of {1}", 1.7, [](vec3 v, vec3 w) { return rt::dot(v, w) < 0 ? -v : v; }},
    {"{0}, turned away from {1}", 1.8, [](vec3 v, vec3 w) { return rt::dot(v, w) > 0 ? -v : v; }},
};

inline constexpr TwoVectors of_two_colors[] = {
    {"{1}", 1.3, [](vec3, vec3 w) { return w; }},
    {"{0} * {1}", 1.6, [](vec3 v, vec3 w) { return v * w; }},
    {"{0} / {1}", 1.8, [](vec3 v, vec3 w) { return v / w; }},
    {"{0} + {1}", 1.7, [](vec3 v, vec3 w) { return v + w; }},
    {"1 - {1}", 1.7, [](vec3, vec3 w) { return 1.0 - w; }},
};

}  // namespace grade
