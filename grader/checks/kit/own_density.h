#pragma once

#include "checks/kit/kit.h"

/// Whether samples have the density that they say, point by point: what a mean over them leaves in its noise, and a
/// chi-squared of a thousand does not see, is exact here.
///
/// A map x(u) of the unit square gives its samples the density
///
///     p(x) = sum over all u' with x(u') = x of 1 / |dx/du'|
///
/// |dx/du| the area over which a small square about u is spread, here by differences. So p |dx/du| is 1 for a map that
/// reaches each point once, a whole number for one that reaches each so often, and never less than 1.
namespace grade {

/// x(u): a direction, or a point. Of fragments that use one number alone, the length of dx/du.x takes the area's place.
using RowPlace = std::function<rt::vec3(const Row& inputs, const Row& outputs)>;

struct OwnDensity {
    RowPlace place;
    RowNumber density;   // that is returned, or that it must be, or that a weight supposes; 0: this one does not count
    std::string words;   // "the density that is returned"
    int dimensions = 2;  // of u
};

/// The fragment's arguments with these numbers.
using RowWith = std::function<Row(Generator& random, rt::vec2 u)>;

/// The fragment is called with numbers u, also near the square's edges, and with those close to them, along each axis;
/// with each of the kinds of arguments in turn. A statistic for each of `all`.
Check own_density(const std::vector<RowWith>& kinds, const std::vector<OwnDensity>& all);
inline Check own_density(const RowWith& row_with, const OwnDensity& of) {
    return own_density(std::vector{row_with}, {of});
}

/// The same for a warp, which keeps strata and patterns together: neighbours stay neighbours.
Check density_of_warp(const std::vector<RowWith>& kinds, const OwnDensity& of);

}  // namespace grade
