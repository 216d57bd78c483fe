#pragma once

#include <algorithm>
#include <cstddef>
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
    std::vector<std::size_t> blocks{};        // that it stands in, the outermost first
    std::size_t known_in = 0;                 // so many of these are where its variables are known
    std::string literal{};                    // of a constant's name: the number that it stands for

    /// Whether it may be written where another one stands.
    bool is_known_at(const Node& other) const {
        return other.blocks.size() >= known_in &&
               std::equal(blocks.begin(), blocks.begin() + std::ptrdiff_t(known_in), other.blocks.begin());
    }
};

}  // namespace grade::textbook
