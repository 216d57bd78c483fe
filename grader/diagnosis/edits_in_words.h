#pragma once

#include "diagnosis/mistakes.h"

namespace grade {

/// One change of a student's own source, or two.
struct Edit {
    const Mistake* first = nullptr;
    const Mistake* second = nullptr;

    double cost() const { return first->cost + (second ? second->cost : 0); }
};

/// Of the first change.
int line_of(const Expressions& all, const Edit& edit);

/// A student's text, as it can be printed, not too long.
std::string printable(std::string text);

/// "with `a * b` in place of `a + b` in line 12, `c = a + b`"
std::string in_words(const Expressions& all, const Edit& edit);

}  // namespace grade
