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
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
vec2 stratified_2d(int i, int n, vec2 u) {
    int columns = sqrt(n);
    int rows = n / columns;
    int x = i % columns;
    int y = i / columns;
    return {(x + u.x) / columns, (y + u.y) / rows};
}

}  // namespace rt
