#pragma once

#include <string>
#include <vector>

#include "class/results.h"

/// What a class has in common. Indices are those of the results.
namespace grade::course {

/// Students whose fragment goes wrong in the same way: the first hint, but for its numbers.
struct Mistake {
    std::string fragment, hint;  // hint: of the first of them; untrusted text
    std::vector<std::size_t> who;
};

/// The most frequent first.
std::vector<Mistake> mistakes(const std::vector<Result>& results);

/// Two students with fragments that are the same but for comments and names. A place to look, no verdict: short
/// fragments, and those that many have, say nothing and are left out.
struct Twins {
    std::size_t a = 0, b = 0;
    std::vector<std::string> fragments;
    int tokens = 0;  // that they share
};

/// Those that share most first.
std::vector<Twins> twins(const std::vector<Result>& results);

}  // namespace grade::course
