#pragma once

#include <string>
#include <vector>

namespace grade::textbook {

/// An expression of a form, or of a student's source.
struct Node {
    std::string text, name, context;          // as it is written; what it is called; the statement that it stands in
    std::string function;                     // that is called there, if it has alternatives
    std::vector<int> parts{};                 // the nodes that it is made of
    std::vector<std::string> alternatives{};  // other operators and functions in its place, in the order of the code
    int line = 0;                             // where it begins in its file
    bool varies = false;                      // a variable in it gets other values: what it was is not what it is
};

}  // namespace grade::textbook
