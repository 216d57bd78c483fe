#include "asked/integrate_stratified.h"
#include "checks/kit/convergence.h"
#include "checks/kit/kit.h"
#include "statistics/regression.h"

namespace grade {

namespace {

using Strata = std::vector<StratumOf>;

constexpr int stratified_levels = 5;

double mean(const std::vector<double>& u) {
    double sum = 0;
    for (const double x : u) sum += x;
    return sum / double(u.size());
}

/// The estimate for f = c0 + c1 x: the sum over the strata of d_t f(mean of the stratum's points), times a factor that
/// may be wrong. Strata without numbers add nothing.
template <class Factor>
auto sum_over_strata(Factor factor) {
    return [=](const Integrand& f, const Strata& strata) {
        double sum = 0;
        for (const StratumOf& s : strata)
            if (!s.u.empty()) sum += (s.high - s.low) * f(s.low + (s.high - s.low) * mean(s.u)) * factor(s, strata);
        return sum;
    };
}

double points_of_all(const Strata& strata) {
    double count = 0;
    for (const StratumOf& s : strata) count += double(s.u.size());
    return count;
}

/// All strata sampled as one interval from the first low to the last high.
double as_one(const Integrand& f, const Strata& strata) {
    const double low = strata.front().low, width = strata.back().high - low, all = points_of_all(strata);
    double sum = 0;
    for (const StratumOf& s : strata)
        for (const double u : s.u) sum += width / all * f(low + u * width);
    return sum;
}

/// Equal strata from low to low + span, one random number to each.
Strata equal_strata(Generator& draw, double low, double span, int count) {
    Strata strata;
    for (int t = 0; t < count; ++t)
        strata.push_back({low + t * span / count, low + (t + 1) * span / count, {between(draw, 0, 1)}});
    return strata;
}

/// A wave with a period to each stratum: regular points see a constant, random ones in the strata see the wave.
Check wave(Generator& random) {
    constexpr int count = 16;
    const double low = between(random, -1, 1), span = between(random, 1, 2);
    const Integrand f{Integrand::Kind::cosine, {1, 1, count / span, between(random, 0, 6)}};
    const auto inputs = rows_of(96, [=](Generator& draw) { return row(f, equal_strata(draw, low, span, count)); });
    return probe_check("wave", inputs,
                       {mean_of({.id = "I1",
                                 .what = "mean estimate of a wave with a period to a stratum, over the integral",
                                 .number = of_call<rt::integrate_stratified>([=](double sum) { return sum / span; }),
                                 .hint = by_ratio("the mean estimate of a wave",
                                                  {{1.0 / count, "are the strata averaged? Expected their sum"},
                                                   {count / span, "is the width of the strata missing?"}})})});
}

Statistic sum_of_given() {
    return formula<rt::integrate_stratified>(
        {.id = "I1",
         .what = "sum over the strata, off by",
         .tolerance = 1e-4,
         .right = sum_over_strata([](const StratumOf&, const Strata&) { return 1.0; }),
         .suspects = {
             {"the sum of each stratum is divided by the number of all points; expected its own number N_t",
              sum_over_strata(
                  [](const StratumOf& s, const Strata& all) { return double(s.u.size()) / points_of_all(all); })},
             {"the sum of each stratum is divided by the number of points of the first one; expected its own number "
              "N_t",
              sum_over_strata([](const StratumOf& s, const Strata& all) {
                  return double(s.u.size()) / double(std::max<std::size_t>(all[0].u.size(), 1));
              })},
             {"the sum of each stratum is not divided by its number of points N_t",
              sum_over_strata([](const StratumOf& s, const Strata&) { return double(s.u.size()); })},
             {"the width d_t of the stratum is missing",
              sum_over_strata([](const StratumOf& s, const Strata&) { return 1 / (s.high - s.low); })},
             {"the strata are averaged; expected their sum",
              [](double right, const Integrand&, const Strata& all) { return right / double(all.size()); }},
             {"a stratum without points gives 0/0; expected that it adds nothing",
              [](double right, const Integrand&, const Strata& all) {
                  return std::ranges::any_of(all, [](const StratumOf& s) { return s.u.empty(); }) ? NAN : right;
              }},
             {"all points are spread over one interval: the strata are not used", as_one}}});
}

}  // namespace

Checks check_integrate_stratified(Generator& random) {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (int k = 0; k < 48; ++k) {
            Strata strata;
            double low = between(random, -1, 1);
            const int count = whole_between(random, 2, 8);
            for (int t = 0; t < count; ++t) {
                StratumOf s{low, low + between(random, 0.1, 0.6), {}};
                // in every third row one stratum is empty; the others have different numbers of points
                const int points = k % 3 == 0 && t == k / 3 % 2 ? 0 : 1 + (t + whole_between(random, 0, 3)) % 5;
                for (int j = 0; j < points; ++j) s.u.push_back(between(random, 0, 1));
                low = s.high + (chance(random, 0.3) ? 0.25 : 0);
                strata.push_back(s);
            }
            const double sign = k % 2 == 0 ? 1 : -1;
            const Integrand f{Integrand::Kind::polynomial,
                              {sign * between(random, 1, 2), sign * between(random, 0.5, 1.5)}};
            rows.push_back(row(f, strata));
        }
        return rows;
    };
    const Statistic calls = property({.id = "I1",
                                      .what = "points used, off by",
                                      .violation =
                                          [](const Row& in, const Row& out) {
                                              const Strata strata = argument<rt::integrate_stratified, 1>(in);
                                              return std::abs(out[1] - points_of_all(strata));
                                          },
                                      .says = "f is not evaluated once for each random number"});
    constexpr int repeats = 12;
    const auto more_strata = [=](Generator& draw) {
        Rows rows;
        for (const int n : levels(stratified_levels))
            for (int k = 0; k < repeats; ++k) {
                const Integrand f{Integrand::Kind::polynomial, {between(draw, 1, 2), 1}};
                rows.push_back(row(f, equal_strata(draw, between(draw, -1, 1), 1, n)));
            }
        return rows;
    };
    const Statistic order = error_order(
        "power of N with which the error falls", stratified_levels, repeats,
        of_call<rt::integrate_stratified>([](double sum, const Integrand& f, const Strata& strata) {
            const double low = strata.front().low, high = strata.back().high;
            return sum - (high - low) * f((low + high) / 2);
        }),
        -1.5, [](double value, double) {
            const std::string off = fmt::format(
                "the error falls as N^{:.2f} with one point in each of N intervals; expected N^-1.5", value);
            return std::abs(value + 0.5) < 0.2
                       ? off + ": are the points spread over one interval? Each has its own stratum"
                   : value > -0.3
                       ? off +
                             ": it hardly falls: does each stratum count once, with its width and its number of points?"
                       : off;
        });
    return {probe_check("given_points", inputs, {sum_of_given(), calls}), wave(random),
            probe_check("convergence", more_strata, {order})};
}

}  // namespace grade
