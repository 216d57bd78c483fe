#include "rt/fragments.h"

namespace rt {

/// Where sample i of n falls in a pixel, and how much it counts in the pixel's mean.
///
/// One sample in each of n cells of equal area (see stratified_2d) leaves less noise than n independent ones.
///
/// pixel    the part of the film that the pixel covers: low <= x < high [pixel]
/// i        the sample, 0 to n - 1
/// n        number of samples in the pixel
/// u        random point of the unit square, 0 <= u < 1: where in the cell
/// returns  point of the film [pixel], and its weight: 1 where all samples count alike
/// blank    the centre of the pixel
///
/// Source: Cook, Porter, Carpenter, "Distributed Ray Tracing", SIGGRAPH 1984.
FilmSample film_sample(const Extent& pixel, int i, int n, vec2 u) {
    vec2 cell = stratified_2d(i, n, u);
    vec2 size = pixel.high - pixel.low;
    return {pixel.low + cell * size, 1};
}

}  // namespace rt
