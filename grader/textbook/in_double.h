#pragma once

#include <optional>
#include <string>
#include <vector>

namespace grade::textbook {

/// A source, and where it differs.
struct Widened {
    std::string text;
    int line;  // of the first difference
    bool is_quotient = false;
};

/// The source with `double` in place of each `float`, of its vectors, constants and functions too. None: it has none.
std::optional<Widened> in_double(const std::string& text);

/// The source with a real number in place of a whole one: of one variable that is declared as `int`, or one quotient.
/// Not of what a loop counts, of parameters, or where a constant such as 0.5 makes it real; no more than six. Where
/// there are several, that with all of these at once comes first.
std::vector<Widened> with_reals(const std::string& text);

}  // namespace grade::textbook
