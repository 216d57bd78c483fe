#pragma once

#include <set>
#include <string>
#include <vector>

#include "textbook/node.h"

/// Textbook forms of fragments, rewritten by the build so that each expression goes through a function of watch.h,
/// where it can be changed: what a fragment with a mistake in the middle of its formula answers.
namespace grade::textbook {

/// A form as it is written, and as it is compiled.
struct Wrapped {
    std::string fragment, head, code;  // head: "Real hit_sphere(const Sphere& sphere, const Ray& ray)"
    std::string says;                  // what is wrong with it, as its first line "// says: ..." has it
    bool has_other_order = false;      // "// says, reordered: ...": a differing answer is not yet a wrong one
    std::vector<Node> nodes;
    std::set<std::string> calls;  // other fragments that it asks
};

/// The one function in a file. first: the number of its first node. Throws std::runtime_error with file:line:column for
/// what it cannot read: of statements it knows declarations, if, for, while, return and assignments.
Wrapped wrap(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first);

}  // namespace grade::textbook
