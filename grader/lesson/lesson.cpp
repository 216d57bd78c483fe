#include "lesson/lesson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "rt/math.h"
#include "statistics/moments.h"
#include "statistics/regression.h"

namespace grade::lesson {

namespace {

constexpr int repeats = 64;         // with other random numbers
constexpr double rounding = 1e-12;  // errors below are no errors of the method
constexpr double least_drawn = 1e-8;

double unit_number(std::mt19937_64& random) { return double(random() >> 11) * 0x1p-53; }

/// Arguments of the method's fragment for n points.
Row arguments(const LessonIntegrand& integrand, Method method, int n, std::mt19937_64& random) {
    if (method == Method::uniform) return row(integrand.f, 0.0, 1.0, n);
    if (method == Method::stratified) {
        std::vector<StratumOf> strata;
        for (int i = 0; i < n; ++i) strata.push_back({double(i) / n, double(i + 1) / n, {unit_number(random)}});
        return row(integrand.f, strata);
    }
    std::vector<double> points;
    for (int i = 0; i < n; ++i) {
        const double u = unit_number(random);
        points.push_back(method == Method::importance ? point_of(integrand, u) : u);
    }
    const Integrand even{Integrand::Kind::polynomial, {1}};
    return row(integrand.f, method == Method::importance ? integrand.density : even, points);
}

/// The error on one level: the root of a mean of squares, and the interval that the scatter of the squares gives it.
LessonPoint level(const LessonIntegrand& integrand, Method method, int n, Runner& runner) {
    std::mt19937_64 random(std::uint64_t(n) + 10'000 * std::uint64_t(method));
    Rows rows;
    for (int k = 0; k < (method == Method::uniform ? 1 : repeats); ++k)
        rows.push_back(arguments(integrand, method, n, random));
    const auto outcome = runner.probe(method_fragments[std::size_t(method)], rows);
    if (const Fault* fault = std::get_if<Fault>(&outcome))
        throw std::runtime_error(fmt::format("{}: {}", method_fragments[std::size_t(method)], fault->message));
    Moments squares;
    for (const Row& out : std::get<Rows>(outcome)) squares.add(std::pow(out.at(0) / integrand.integral - 1, 2));
    LessonPoint point{n, std::sqrt(squares.mean)};
    // no error at all is as good as one that nobody sees
    point.error = std::max(point.error, 1e-17);
    const double reach = 1.96 * squares.standard_error();
    if (reach > 0) {
        point.low = std::sqrt(std::max(squares.mean - reach, 0.0));
        point.high = std::sqrt(squares.mean + reach);
    }
    return point;
}

}  // namespace

std::vector<LessonIntegrand> lesson_integrands() {
    using Kind = Integrand::Kind;
    const double center = 0.4, width = 0.01, rate = 2, waves = 8, phase = 1;
    const double before = std::atan(center / width), all = before + std::atan((1 - center) / width);
    return {
        {"smooth",
         "A smooth function, exp(-2x)",
         {Kind::exponential, {1, rate}},
         (1 - std::exp(-rate)) / rate,
         {Kind::polynomial, {1.8, -1.6}},
         [](double x) { return 1.8 * x - 0.8 * x * x; }},
        {"peaked",
         "A peak, a hundredth of the domain wide",
         {Kind::gaussian, {1, center, width}},
         width * std::sqrt(2 * rt::pi),
         {Kind::lorentzian, {1 / (width * all), center, width}},
         [=](double x) { return (std::atan((x - center) / width) + before) / all; }},
        {"periodic",
         "Eight waves",
         {Kind::cosine, {1, 0.9, waves, phase}},
         1,
         {Kind::cosine, {1, 0.7, waves, phase}},
         [=](double x) {
             const double turn = 2 * rt::pi * waves;
             return x + 0.7 * (std::sin(turn * x + phase) - std::sin(phase)) / turn;
         }},
    };
}

double point_of(const LessonIntegrand& integrand, double u) {
    double low = 0, high = 1;
    for (int step = 0; step < 44; ++step) {
        const double middle = (low + high) / 2;
        (integrand.cumulative(middle) < u ? low : high) = middle;
    }
    return low;
}

LessonCurve lesson_curve(const LessonIntegrand& integrand, Method method, Runner& runner) {
    LessonCurve curve{method, {}, {}};
    std::vector<double> n, errors;
    for (int count = 1; count <= most_lesson_points; count *= 2) {
        curve.points.push_back(level(integrand, method, count, runner));
        if (count >= 64) n.push_back(count), errors.push_back(curve.points.back().error);
    }
    if (*std::ranges::min_element(errors) > rounding) curve.slope = log_log_slope(n, errors);
    return curve;
}

Plot lesson_plot(const LessonIntegrand& integrand, const std::vector<LessonCurve>& curves) {
    Plot plot{integrand.title, "points", "error / integral (1e-8: that or less)", {}};
    plot.least_y = least_drawn;
    plot.guides = {{-0.5, "N^-1/2"}, {-1.5, "N^-3/2"}, {-2, "N^-2"}};
    for (const LessonCurve& curve : curves) {
        Series series{method_names[std::size_t(curve.method)], {}};
        series.color = int(curve.method);
        series.name += curve.slope ? fmt::format(": N^{:.2f}", *curve.slope) : ": then exact";
        for (const LessonPoint& p : curve.points) series.points.push_back({double(p.n), p.error, p.low, p.high});
        plot.series.push_back(series);
    }
    return plot;
}

}  // namespace grade::lesson
