#include "statistics/tests.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "statistics/distributions.h"

namespace grade {

ChiSquared chi_squared_test(std::span<const double> observed, std::span<const double> expected, double least) {
    std::vector<int> order(observed.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return expected[a] < expected[b]; });

    // pools; what is left over stays with the last full one
    struct Pool {
        double seen = 0, due = 0;
    };
    std::vector<Pool> pools(1);
    bool impossible = false;
    for (int bin : order) {
        impossible = impossible || (expected[bin] <= 0 && observed[bin] > 0);
        if (pools.back().due >= least) pools.emplace_back();
        pools.back().seen += observed[bin];
        pools.back().due += expected[bin];
    }
    if (pools.size() > 1 && pools.back().due < least) {
        const Pool rest = pools.back();
        pools.pop_back();
        pools.back().seen += rest.seen;
        pools.back().due += rest.due;
    }

    ChiSquared result;
    for (const Pool& pool : pools)
        if (pool.due > 0) result.statistic += (pool.seen - pool.due) * (pool.seen - pool.due) / pool.due;
    result.degrees = int(pools.size()) - 1;
    if (impossible)
        result.p = 0;
    else if (result.degrees > 0)
        result.p = chi_squared_tail(result.degrees, result.statistic);
    return result;
}

Welch welch_test(const Moments& a, const Moments& b) {
    const double va = a.variance() / a.count, vb = b.variance() / b.count, v = va + vb;
    Welch result{a.mean - b.mean, std::sqrt(v), a.count + b.count - 2, 0, 1};
    if (!std::isfinite(v) || !std::isfinite(result.difference)) {
        result.t = 0;  // numbers whose squares are none: there is nothing to tell by
    } else if (v > 0) {
        const double share = va / v;
        result.degrees = 1 / (share * share / (a.count - 1) + (1 - share) * (1 - share) / (b.count - 1));
        result.t = result.difference / result.se;
        result.p = 2 * student_tail(result.degrees, std::abs(result.t));
    } else if (result.difference != 0) {
        result.t = std::copysign(INFINITY, result.difference);
        result.p = 0;
    }
    return result;
}

}  // namespace grade
