#pragma once

#include "checks/kit/estimate.h"

/// How the error of an estimate falls with the number of its samples, and what is left of what is too fine for it.
namespace grade {

/// A fragment that places sample i of n in a square: its row of arguments for the pixel at `low`, one unit wide, where
/// it knows about pixels, and the sample's place in the square, 0 to 1, with its weight.
struct SamplesOfASquare {
    struct Sample {
        rt::vec2 place{0};
        double weight = 1;
    };
    std::function<Row(rt::vec2 low, int i, int n, rt::vec2 u)> arguments;
    std::function<Sample(const Row& inputs, const Row& outputs)> sample;
};

/// G3: the slope of log error against log samples, for a plane and for a tilted edge.
Check error_orders(Generator& random, const SamplesOfASquare& samples);

/// A2: what is left of rings too fine for the pixels, in many pixels whose place is known.
Check rings(Generator& random, const SamplesOfASquare& samples);

/// G3 of a fragment that adds up by itself: so many estimates on each of the levels, one after the other.
///
/// error  of one estimate
Statistic error_order(std::string what, int count_of_levels, int repeats, RowNumber error, double slope, Hint hint);

}  // namespace grade
