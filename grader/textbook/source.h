#pragma once

#include <set>
#include <string>
#include <vector>

#include "textbook/node.h"

namespace grade::textbook {

/// A student's source, whose expressions can be changed while it runs.
struct EditableSource {
    std::string text;  // to compile in its place
    std::vector<Node> nodes;
    std::set<std::string> varying;  // variables, and arguments, that get other values
};

/// Whether the source has macros or conditions of its own, or whatever else but #include and #pragma.
bool needs_preprocessor(const std::string& text);

/// Of what it can read; the rest stays as it is. It knows functions, also within structs, and lambdas. Throws a
/// std::exception for a source that it cannot read, or that needs_preprocessor().
EditableSource editable(const std::string& text);

/// watched.h, which a compiler reads before such a source.
extern const char* const watched_text;

}  // namespace grade::textbook
