#pragma once

#include <algorithm>

#include "diagnosis/forms/mistakes.h"

namespace grade {

/// One change of a student's own source, or two; or one of an expression in two places.
struct Edit {
    const Mistake* first = nullptr;
    const Mistake* second = nullptr;
    bool in_one_expression = false;

    double cost() const {
        constexpr double of_another = 0.1;
        if (in_one_expression) return std::max(first->cost, second->cost) + of_another;
        return first->cost + (second ? second->cost : 0);
    }
};

/// Of the first change.
int line_of(const Expressions& all, const Edit& edit);

/// A student's text, as it can be printed, not too long.
std::string printable(std::string text);

/// "with `a * b` in place of `a + b` in line 12, `c = a + b`"
std::string in_words(const Expressions& all, const Edit& edit);

}  // namespace grade
