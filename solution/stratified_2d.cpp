#include <algorithm>

#include "rt/fragments.h"

namespace rt {

/// A random point in cell i of n cells of equal area that tile the unit square.
///
/// Where n is a square, the cells are a grid of sqrt(n) by sqrt(n). Elsewhere: c = floor(sqrt(n)) columns, column j
/// holding the cells ceil(j n/c) to ceil((j+1) n/c) - 1, as wide as the share of the cells that it holds, and they
/// share its height.
///
/// i        the cell, 0 to n - 1
/// n        number of cells, > 0
/// u        random point of the unit square, 0 <= u < 1: where in the cell
/// returns  point of the unit square, 0 <= x < 1 in each coordinate; no two cells overlap
/// blank    u: independent samples
///
/// The sum i + u may be rounded up to i + 1, hence to 1 in the last cell: never return more than below_one.
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
vec2 stratified_2d(int i, int n, vec2 u) {
    // BEGIN SOLUTION
    const Real columns = std::floor(std::sqrt(Real(n)));
    const Real column = std::floor(i * columns / n);
    const Real first = std::ceil(column * n / columns), next = std::ceil((column + 1) * n / columns);
    const Real x = (first + u.x * (next - first)) / n, y = (i - first + u.y) / (next - first);
    return {std::min(x, below_one), std::min(y, below_one)};
    // END SOLUTION: return not_started(u);
}

}  // namespace rt
