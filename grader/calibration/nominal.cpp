#include "calibration/nominal.h"

#include <cmath>
#include <random>

#include "judging/experiment.h"
#include "statistics/distributions.h"
#include "statistics/moments.h"

namespace grade::calibration {

namespace {

constexpr int replicates = 16;

Nominal nominal_rate(const Check& check, std::size_t i, const Pool& pool, int draws, std::mt19937_64& random) {
    const Statistic& statistic = check.statistics[i];
    Nominal nominal{key_of(check), statistic.what};
    std::vector<double> all;
    for (int k = 0; k < pool.replicates(); ++k) all.push_back(pool.scalar(k, i));
    const Moments moments = moments_of(all);
    const double off = std::abs(moments.mean - statistic.truth.value_or(moments.mean));
    nominal.bias = off / statistic.delta;
    nominal.tilt = (off - statistic.delta0) / moments.standard_error();
    nominal.spread = moments.deviation() / statistic.delta;

    const double t_2 = student_quantile(replicates - 1, 1e-2 / 2), t_3 = student_quantile(replicates - 1, 1e-3 / 2);
    std::uniform_int_distribution<std::size_t> any(0, all.size() - 1);
    int beyond_2 = 0, beyond_3 = 0;
    for (int k = 0; k < draws; ++k) {
        Moments few;
        for (int r = 0; r < replicates; ++r) few.add(all[any(random)]);
        // about the store's own mean: what is tested here is the shape of the distribution
        const double t = std::abs(few.mean - moments.mean) / few.standard_error();
        beyond_2 += t > t_2, beyond_3 += t > t_3;
    }
    nominal.at_2 = beyond_2 / (1e-2 * draws), nominal.at_3 = beyond_3 / (1e-3 * draws);
    return nominal;
}

}  // namespace

std::vector<Nominal> nominal_rates(const PooledChecks& checks, int draws, std::uint64_t random_seed) {
    std::mt19937_64 random(random_seed);
    std::vector<Nominal> rates;
    for (const auto& [check, pool] : checks)
        for (std::size_t i = 0; i < check->statistics.size(); ++i)
            if (!check->statistics[i].exact && pool->replicates() > 1)
                if (const Nominal rate = nominal_rate(*check, i, *pool, draws, random); rate.spread > 1e-6)
                    rates.push_back(rate);
    return rates;
}

}  // namespace grade::calibration
