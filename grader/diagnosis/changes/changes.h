#pragma once

#include <functional>

#include "diagnosis/calls/arguments.h"

/// Mistakes that are made in any formula, as changes of its arguments: what the right fragment answers for changed
/// arguments is what a fragment with that mistake answers.
namespace grade {

struct Change {
    std::string words;                                         // "`u.x` in place of `u.y`"; empty: nothing is changed
    double cost = 0;                                           // the simpler, the less
    std::function<bool(Row& row, const Layout& layout)> make;  // false: it makes no arguments
    std::string usually{};                                     // what that is in most code, if it is the only one
};

/// All that make sense for arguments of these kinds, the simplest first. told: the parts that matter.
std::vector<Change> changes_of(const Layout& layout, const std::vector<bool>& told);

/// Other random numbers that are as good: u.x and u.y exchanged, 1 - u. The first one changes nothing.
std::vector<Change> same_sampling(const Layout& layout);

}  // namespace grade
