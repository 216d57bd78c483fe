#pragma once

#include "catch.h"
#include "textbook/source.h"

/// What tests of students' sources share.
namespace grade {

/// A source that defines `Real f(Real x, vec2 u)`, whose body begins in line 6.
inline std::string function(const std::string& body) {
    return "#include \"rt/fragments.h\"\n\nnamespace rt {\n\nReal f(Real x, vec2 u) {\n" + body + "}\n\n}\n";
}

/// The first expression that reads so.
inline const textbook::Node& node(const textbook::EditableSource& source, const std::string& text) {
    const auto found = std::ranges::find(source.nodes, text, &textbook::Node::text);
    REQUIRE(found != source.nodes.end());
    return *found;
}

}  // namespace grade
