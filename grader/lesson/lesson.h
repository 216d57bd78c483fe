#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "programs/runner.h"
#include "protocol/rows.h"
#include "report/plot.h"

/// The lesson of part 1: how the error of an integral in one dimension falls with the number of points, by the way the
/// points are chosen.
namespace grade::lesson {

/// A function on [0, 1] whose integral is known, and a density that is high where the function is.
struct LessonIntegrand {
    std::string name, title;
    Integrand f;
    double integral;
    Integrand density;
    std::function<double(double)> cumulative;  // of the density, from 0 to 1
};

/// The smooth, the peaked and the periodic one.
std::vector<LessonIntegrand> lesson_integrands();

/// A point whose cumulative density is u, by bisection.
double point_of(const LessonIntegrand& integrand, double u);

/// How the points are chosen, and which fragment adds up.
enum class Method { uniform, random, stratified, importance };
constexpr std::array<const char*, 4> method_names{"uniform", "random", "stratified", "importance"};
constexpr std::array<const char*, 4> method_fragments{"integrate_uniform", "integrate_monte_carlo",
                                                      "integrate_stratified", "integrate_monte_carlo"};

struct LessonPoint {
    int n;
    double error;              // root mean square of the error / the integral
    double low = 0, high = 0;  // its 95 % interval; uniform points have none
};

struct LessonCurve {
    Method method;
    std::vector<LessonPoint> points;
    std::optional<double> slope;  // from 64 points on; none where rounding is all that is left
};

/// The greatest number of points.
constexpr int most_lesson_points = 4096;

/// Asks the fragment for sums over 1, 2, 4 ... points, many times with other random numbers: the same on every run.
/// Throws std::runtime_error where the fragment breaks down.
LessonCurve lesson_curve(const LessonIntegrand& integrand, Method method, Runner& runner);

Plot lesson_plot(const LessonIntegrand& integrand, const std::vector<LessonCurve>& curves);

}  // namespace grade::lesson
