#include "statistics/multiplicity.h"

#include <algorithm>
#include <numeric>

namespace grade {

std::vector<bool> holm(std::span<const double> p, double alpha) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });

    std::vector<bool> rejected(p.size(), false);
    for (std::size_t k = 0; k < order.size() && p[order[k]] <= alpha / double(order.size() - k); ++k)
        rejected[order[k]] = true;
    return rejected;
}

}  // namespace grade
