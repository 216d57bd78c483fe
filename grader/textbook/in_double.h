#pragma once

#include <optional>
#include <string>

namespace grade::textbook {

/// A source, and where it differs.
struct Widened {
    std::string text;
    int line;  // of the first difference
};

/// The source with `double` in place of each `float`, of its vectors, constants and functions too. None: it has none.
std::optional<Widened> in_double(const std::string& text);

}  // namespace grade::textbook
