#include "checks/draw.h"
#include "checks/formula.h"
#include "checks/fragment_checks.h"
#include "checks/probe_check.h"

namespace grade {

namespace {

using Strata = std::vector<StratumOf>;

double mean(const std::vector<double>& u) {
    double sum = 0;
    for (const double x : u) sum += x;
    return sum / double(u.size());
}

/// The estimate for f = c0 + c1 x: the sum over the strata of d_t f(mean of the stratum's points), times a factor that may
/// be wrong. Strata without numbers add nothing.
RowFunction estimate(std::function<double(const StratumOf&, const Strata&)> factor) {
    return of<Integrand, Strata>([=](const Integrand& f, const Strata& strata) {
        double sum = 0;
        for (const StratumOf& s : strata)
            if (!s.u.empty()) sum += (s.high - s.low) * f(s.low + (s.high - s.low) * mean(s.u)) * factor(s, strata);
        return Row{sum};
    });
}

double points_of_all(const Strata& strata) {
    double count = 0;
    for (const StratumOf& s : strata) count += double(s.u.size());
    return count;
}

/// All strata sampled as one interval from the first low to the last high.
Row as_one(const Integrand& f, const Strata& strata) {
    const double low = strata.front().low, width = strata.back().high - low, all = points_of_all(strata);
    double sum = 0;
    for (const StratumOf& s : strata)
        for (const double u : s.u) sum += width / all * f(low + u * width);
    return {sum};
}

}  // namespace

Checks check_integrate_stratified(Generator&) {
    const auto inputs = [](Generator& random) {
        Rows rows;
        for (int k = 0; k < 48; ++k) {
            Strata strata;
            double low = between(random, -1, 1);
            const int count = whole_between(random, 2, 8);
            for (int t = 0; t < count; ++t) {
                StratumOf s{low, low + between(random, 0.1, 0.6), {}};
                // in every third row one stratum is empty; the others have different numbers of points
                const int points = k % 3 == 0 && t == 1 ? 0 : 1 + (t + whole_between(random, 0, 3)) % 5;
                for (int j = 0; j < points; ++j) s.u.push_back(between(random, 0, 1));
                low = s.high + (chance(random, 0.3) ? 0.25 : 0);
                strata.push_back(s);
            }
            const Integrand f{Integrand::Kind::polynomial, {between(random, 1, 2), between(random, 0.5, 1.5)}};
            rows.push_back(row(f, strata));
        }
        return rows;
    };
    const auto right = estimate([](const StratumOf&, const Strata&) { return 1.0; });
    Statistic value = formula(
        "I1", "sum over the strata, off by", right, 1e-4,
        {{"the sum of each stratum is divided by the number of all points; expected its own number N_t",
          estimate([](const StratumOf& s, const Strata& all) { return double(s.u.size()) / points_of_all(all); })},
         {"the sum of each stratum is divided by the number of points of the first one; expected its own number N_t",
          estimate([](const StratumOf& s, const Strata& all) { return double(s.u.size()) / double(all[0].u.size()); })},
         {"the sum of each stratum is not divided by its number of points N_t",
          estimate([](const StratumOf& s, const Strata&) { return double(s.u.size()); })},
         {"the width d_t of the stratum is missing", estimate([](const StratumOf& s, const Strata&) { return 1 / (s.high - s.low); })},
         {"the strata are averaged; expected their sum",
          estimate([](const StratumOf&, const Strata& all) { return 1 / double(all.size()); })},
         {"a stratum without points gives 0/0; expected that it adds nothing", estimate([](const StratumOf&, const Strata& all) {
              for (const StratumOf& s : all)
                  if (s.u.empty()) return double(NAN);
              return 1.0;
          })},
         {"all points are spread over one interval: the strata are not used", of<Integrand, Strata>(as_one)}});
    Statistic calls = property("I1", "points used",
        [](const Row& in, const Row& out) {
            return std::abs(out[1] - points_of_all(argument<1, Integrand, Strata>(in)));
        },
        0, "f is not evaluated once for each random number");
    return {probe_check("given_points", "integrate_stratified", {}, inputs, {value, calls})};
}

}  // namespace grade
