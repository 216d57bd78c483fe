#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "textbook/watched.h"

/// How expressions of a form are changed while it is computed.
namespace grade::textbook {

/// A value that was seen.
struct Value {
    enum class Kind { none, number, whole, flag, pair, vector };
    Kind kind = Kind::none;
    double x[3]{};
};

/// What becomes of a value: a constant, a function of it in a table of functions.h, or of it and another value.
enum class Made {
    nothing,
    yes,
    no,
    opposite,
    number,
    tolerance,
    tolerance_with,
    limit,
    share,
    pair,
    exchanged,  // the numbers of a pair
    vector,
    color,
    number_with,
    pair_with,
    vector_with,
    color_with,
    scaled_with,
};

/// A mistake in an expression, or in several alike: another of its operators or functions, or another value.
struct Mistake {
    std::vector<int> nodes;
    int alternative = 0;  // 0: none
    Made made = Made::nothing;
    std::size_t function = 0;  // in its table
    int other_node = -1;       // the other value's
    std::size_t other_at = 0;  // else in the row of arguments

    bool is_of(int node) const { return std::ranges::find(nodes, node) != nodes.end(); }
};

/// Of the thread's present call.
struct Watch {
    int first = 0;                // the form's first node
    std::vector<Value> values;    // of its nodes, the latest
    std::span<const double> row;  // of arguments
    const Mistake* mistakes[2]{};
    std::size_t passed = 0;  // values so far: a mistake may make a loop that does not end

    /// Before the next call.
    void begin(int first_node, std::size_t nodes, std::span<const double> arguments, const Mistake* one,
               const Mistake* another);
};
extern thread_local Watch watch;

}  // namespace grade::textbook
