#pragma once

#include "checks/kit/formula.h"

/// Fragments that sample: what their outputs must be on average, and how they must be spread.
namespace grade {

/// The mean over the rows, against a closed form. What is a thousandth of the unit off is right, what is a twentieth
/// off must be found, unless it is said otherwise.
struct Mean {
    std::string id, what;
    RowNumber number;
    double truth = 1;
    std::optional<double> unit{};  // none: the truth, or 1 where that is 0
    std::optional<double> delta0{}, delta{};
    Hint hint;
    Cause cause{};
};
Statistic mean_of(const Mean& mean);

/// For a mean that is a share of light: half a percent of it must be found.
Statistic find_half_a_percent(Statistic mean);

/// Two coordinates of each row that must be independent and uniform in the unit square: Pearson's chi-squared over a
/// grid of cells, over its degrees of freedom, which is 1 on average. A coordinate outside is a count where none can
/// be. Rows for which it is nan are left out.
using RowPoint = std::function<rt::vec2(const Row& inputs, const Row& outputs)>;
struct Evenness {
    std::string id, what;
    RowPoint point;
    int columns = 8, rows = 8;
    double delta0 = 0.02, delta = 0.5;
    Hint hint;
    Cause cause{};
};
Statistic uniform_in_square(const Evenness& evenness);

/// A hint that does not depend on the value, and one that names it where {:.3g} or the like stands.
Hint always(std::string words);
Hint with_value(std::string words);

/// A value that a known mistake leads to, and what that mistake is.
struct KnownValue {
    double value;
    std::string words;
};

/// A hint that names the known value that is nearest, if it is nearer than `near`, and others that are closer to it
/// than a quarter of that, since nothing tells them apart; else `else_words`.
Hint by_value(std::string what, std::vector<KnownValue> known, double near, std::string else_words = "");

/// The same for the ratio value/truth: {{2.0, "the radius is the diameter"}, ...}.
Hint by_ratio(std::string what, std::vector<KnownValue> known, std::string else_words = "");

/// A hint whose known values take a while: made where it is told.
inline Hint hint_later(std::function<Hint()> make) {
    return [make = std::move(make)](double value, double truth) { return make()(value, truth); };
}

}  // namespace grade
