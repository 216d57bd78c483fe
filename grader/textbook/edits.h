#pragma once

#include <vector>

#include "textbook/watch.h"

/// What the grader asks of a program whose expressions can be changed: rows of numbers, each a call with mistakes.
namespace grade::textbook {

using Numbers = std::vector<double>;

/// A call, and up to two mistakes in the expressions of what it calls, which has `nodes` of them. With `only_kinds`,
/// the answer is of which kind each expression's value is, as a Value::Kind, with a mark where it is none in the usual
/// sense.
struct EditedCall {
    std::size_t nodes = 0;
    bool only_kinds = false;
    std::vector<Mistake> mistakes{};
    Numbers arguments{};
    Numbers more{};  // that mistakes may take, counted on from the arguments
};

/// Of values: a number that is none, that is infinite, that is 0.
constexpr double mark_of_nan = 0.5, mark_of_infinity = 0.25, mark_of_zero = 0.125;
/// A value's kind and its mark.
double seen(const Value& value);

Numbers row_of(const EditedCall& call, const Mistake* first = nullptr, const Mistake* second = nullptr);

/// Throws std::out_of_range or std::domain_error for a row that is none.
EditedCall edited_call_of(std::span<const double> row);

}  // namespace grade::textbook
