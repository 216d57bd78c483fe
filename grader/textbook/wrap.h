#pragma once

#include <string>
#include <vector>

/// Textbook forms of fragments, rewritten by the build so that each expression goes through a function of watch.h,
/// where it can be changed: what a fragment with a mistake in the middle of its formula answers.
namespace grade::textbook {

/// An expression of a form.
struct WrappedNode {
    std::string text, name, context;        // as it is written; what it is called; the statement that it stands in
    std::string function;                   // that is called there, if it has alternatives
    std::vector<int> parts{};               // the nodes that it is made of
    std::vector<std::string> alternatives;  // other operators and functions in its place, in the order of the code
};

/// A form as it is written, and as it is compiled.
struct Wrapped {
    std::string fragment, head, code;  // head: "Real hit_sphere(const Sphere& sphere, const Ray& ray)"
    std::string says;                  // what is wrong with it, as its first line "// says: ..." has it
    std::vector<WrappedNode> nodes;
};

/// The one function in a file. first: the number of its first node. Throws std::runtime_error with file:line:column for
/// what it cannot read: of statements it knows declarations, if, for, while, return and assignments.
Wrapped wrap(const std::string& file, const std::string& text, const std::vector<std::string>& fragments, int first);

}  // namespace grade::textbook
