#pragma once

#include "checks/kit/check.h"

/// Fragments that sample: what their outputs must be on average, and how they must be spread.
namespace grade {

/// A number of each row, whose mean over the rows is the replicate's scalar.
using RowNumber = std::function<double(const Row& inputs, const Row& outputs)>;
using Hint = std::function<std::string(double value, double truth)>;

/// The mean over the rows, against a closed form. What is a hundredth off is right, what is five hundredths off must be
/// found, of the truth or of the unit where the truth is 0.
Statistic mean_of(std::string id, std::string what, RowNumber number, double truth, double unit, Hint hint);

/// For a mean that is a share of light: half a percent of it must be found.
void find_half_a_percent(Statistic& mean);

/// Two coordinates of each row that must be independent and uniform in the unit square: Pearson's chi-squared over a
/// grid of cells, over its degrees of freedom, which is 1 on average. A coordinate outside is a count where none can
/// be. Rows for which it is nan are left out.
using RowPoint = std::function<rt::vec2(const Row& inputs, const Row& outputs)>;
Statistic uniform_in_square(std::string id, std::string what, RowPoint point, int columns, int rows, Hint hint);

/// A hint that does not depend on the value.
Hint always(std::string words);

/// A value that a known mistake leads to, and what that mistake is.
struct KnownValue {
    double value;
    std::string words;
};

/// The words of the known value that is nearest, if it is nearer than `near`; those of others that are closer to it
/// than a quarter of that are named as well, since nothing tells them apart.
std::string nearest_words(const std::vector<KnownValue>& known, double value, double near);

/// A hint that compares the ratio value/truth with known ones: {{2.0, "the radius is the diameter"}, ...}; `else_words`
/// gets the ratio put in front.
using KnownRatio = KnownValue;
Hint by_ratio(std::string what, std::vector<KnownRatio> known, std::string else_words = "");

}  // namespace grade
