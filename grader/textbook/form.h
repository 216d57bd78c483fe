#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "textbook/watch.h"

namespace grade::textbook {

struct Node {
    const char *text, *name, *context;      // as it is written; what it is called; the statement that it stands in
    const char* function;                   // that is called there, if it has alternatives
    std::vector<int> parts;                 // the nodes that it is made of
    std::vector<const char*> alternatives;  // of its operator or function
};

/// A fragment as a textbook writes it, each of whose expressions can be changed.
struct Form {
    std::string fragment;
    std::string says;  // what is wrong with it; empty: it is right
    int first = 0;     // the number of its first node
    std::vector<Node> nodes;
    std::function<std::vector<double>(std::span<const double>)> answer;  // to a row of arguments
};

/// Of all fragments: right ones, made by the build from forms/, and from solution/ where a fragment has none there; then
/// those that are wrong as a whole, from mistakes/.
const std::vector<Form>& forms();

}  // namespace grade::textbook
