#include "statistics/chi_squared.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "statistics/distributions.h"

namespace grade {

ChiSquared chi_squared_test(std::span<const double> observed, std::span<const double> expected, double least) {
    std::vector<int> order(observed.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) { return expected[a] < expected[b]; });

    ChiSquared result;
    double seen = 0, due = 0;  // of the pool that is being filled
    int bins = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const int bin = order[k];
        if (expected[bin] <= 0 && observed[bin] > 0) return {result.statistic, bins, 0};
        seen += observed[bin];
        due += expected[bin];

        const bool last = k + 1 == order.size();
        if (due < least && !last) continue;
        if (due <= 0) continue;
        result.statistic += (seen - due) * (seen - due) / due;
        ++bins;
        seen = due = 0;
    }
    result.degrees = bins - 1;
    if (result.degrees > 0) result.p = chi_squared_tail(result.degrees, result.statistic);
    return result;
}

}  // namespace grade
