#include "asked/integrate_uniform.h"
#include "checks/kit/convergence.h"
#include "checks/kit/kit.h"
#include "statistics/regression.h"

namespace grade {

namespace {

constexpr int uniform_levels = 5;

/// The sum over n points with the given offset in their cells, 1/2 for midpoints, of offset + height cos(w x + phase),
/// in closed form:
///
///     D offset + h height cos(w (m + (shift - 1/2) h) + phase) sin(w D/2) / sin(w h/2),   h = D/n, m = (a + b)/2
double sum_of_cosine(const Integrand& f, double a, double b, int n, double shift) {
    const double w = 2 * rt::pi * f.parameters[2], span = b - a, h = span / n;
    const double sine = std::sin(w * h / 2);
    const double gain = std::abs(sine) < 1e-12 ? n : std::sin(w * span / 2) / sine;
    return span * f.parameters[0] +
           h * f.parameters[1] * std::cos(w * ((a + b) / 2 + (shift - 0.5) * h) + f.parameters[3]) * gain;
}

auto shifted(double shift) {
    return [=](const Integrand& f, double a, double b, int n) { return sum_of_cosine(f, a, b, n, shift); };
}

Statistic regular_sum() {
    return formula<rt::integrate_uniform>(
        {.id = "I1",
         .what = "sum over regular points, off by",
         .tolerance = 1e-4,
         .right = shifted(0.5),
         .suspects = {
             {"the sum runs over left end points, x_i = a + i D/n; expected the middle of each interval", shifted(0)},
             {"the sum runs over right end points; expected the middle of each interval", shifted(1)},
             {"this is the trapezoidal rule, over n + 1 points; expected the midpoints",
              [](const Integrand& f, double a, double b, int n) {
                  return (sum_of_cosine(f, a, b, n, 0) + sum_of_cosine(f, a, b, n, 1)) / 2;
              }},
             {"the factor D is missing",
              [](double right, const Integrand&, double a, double b, int) { return right / (b - a); }},
             {"the factor 1/N is missing",
              [](double right, const Integrand&, double, double, int n) { return right * n; }},
             {"the factor D/N is missing",
              [](double right, const Integrand&, double a, double b, int n) { return right * n / (b - a); }}}});
}

/// That f was called at the right points, several times at each; empty: it was not.
std::string called_more_often(const Observation& seen) {
    const double times = seen.outputs.front()[1] / seen.inputs.front().back();
    for (std::size_t k = 0; k < seen.inputs.size(); ++k)
        if (seen.outputs[k][1] != times * seen.inputs[k].back()) return {};
    return times > 1 && times == std::floor(times)
               ? fmt::format("f is called {} times at each point; expected once: keep its value in a variable", times)
               : "";
}

/// The probe also says how often f was called, and between which x.
Statistic points_used() {
    Statistic s =
        property({.id = "I1",
                  .what = "points used, off by",
                  .violation =
                      [](const Row& in, const Row& out) {
                          return of_arguments<rt::integrate_uniform>([&](const Integrand&, double a, double b, int n) {
                              const double h = (b - a) / n;
                              return std::max({std::abs(out[1] - n), std::abs(out[2] - (a + h / 2)) / h,
                                               std::abs(out[3] - (b - h / 2)) / h});
                          })(in);
                      },
                  .tolerance = 1e-3,
                  .says = "f is not evaluated once at each of the N midpoints, from a + D/(2N) to b - D/(2N)"});
    s.cause = called_more_often;
    return s;
}

/// The integral of height exp(-rate x), the same functions on each level.
Check error_by_points() {
    constexpr int repeats = 4;
    const auto more_points = [=](Generator& random) {
        std::vector<Row> functions;
        std::vector<std::pair<double, double>> ranges;
        for (int k = 0; k < repeats; ++k) {
            const double a = between(random, -1, 1), span = between(random, 0.5, 1.5);
            functions.push_back(
                row(Integrand{Integrand::Kind::exponential, {between(random, 1, 2), between(random, 0.5, 1)}}));
            ranges.emplace_back(a, a + span);
        }
        Rows rows;
        for (const int n : levels(uniform_levels))
            for (int k = 0; k < repeats; ++k) {
                rows.push_back(functions[std::size_t(k)]);
                const auto [a, b] = ranges[std::size_t(k)];
                rows.back().insert(rows.back().end(), {a, b, double(n)});
            }
        return rows;
    };
    const Statistic order = error_order(
        "power of N with which the error falls", uniform_levels, repeats,
        of_call<rt::integrate_uniform>([](double sum, const Integrand& f, double a, double b, int) {
            return sum - (f(a) - f(b)) / f.parameters[1];
        }),
        -2, [](double value, double) {
            const std::string off = fmt::format("the error falls as N^{:.2f} with N points; expected N^-2", value);
            return std::abs(value + 1) < 0.3
                       ? off + ": are the points at the ends of the intervals? Expected their middles"
                   : value > -0.3 ? off + ": it hardly falls: is each interval counted, once, with its width D/N?"
                                  : off;
        });
    return probe_check("convergence", more_points, {order});
}

}  // namespace

Checks check_integrate_uniform(Generator&) {
    const auto inputs = rows_of(64, [](Generator& random) {
        const double a = between(random, -2, 2), span = between(random, 0.5, 3);
        const bool are_many = chance(random, 0.15);
        const int n = are_many ? whole_between(random, 300, 500) : whole_between(random, 3, 60);
        // slow enough for the sum to be far from zero, or once a point: then the regular points alias
        const double frequency = !are_many && chance(random, 0.25) ? n / span * (1 + 1e-3)
                                                                   : between(random, 0.1, 0.4 * std::min(n, 60)) / span;
        const double sign = chance(random, 0.5) ? 1 : -1;
        const Integrand f{
            Integrand::Kind::cosine,
            {sign * between(random, 1, 2), sign * between(random, 0.5, 1), frequency, between(random, 0, 6)}};
        return row(f, a, a + span, n);
    });

    // from right to left the integral has the other sign
    const auto backwards = [inputs](Generator& random) {
        Rows rows = inputs(random);
        for (Row& r : rows) std::swap(r[r.size() - 3], r[r.size() - 2]);
        return rows;
    };
    return {probe_check("regular_points", inputs, {regular_sum(), points_used()}),
            probe_check("backwards", backwards, {regular_sum()}), error_by_points()};
}

}  // namespace grade
