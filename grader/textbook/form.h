#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "textbook/node.h"
#include "textbook/watch.h"

namespace grade::textbook {

using Answer = std::function<std::vector<double>(std::span<const double>)>;

/// A fragment as a textbook writes it, each of whose expressions can be changed.
struct Form {
    std::string fragment;
    std::string says;      // what is wrong with it; empty: it is right
    bool has_other_order;  // samples come in another order than the solution's: an answer that differs may be right
    int first = 0;         // the number of its first node
    std::vector<Node> nodes;
    Answer answer;  // to a row of arguments
};

/// Right ones, made by the build from forms/, and those that are wrong as a whole, from mistakes/. A fragment needs no
/// form.
const std::vector<Form>& forms();

/// As wrap_forms writes them.
std::vector<Form> read_forms(std::span<const unsigned char> texts, std::span<const std::uint32_t> numbers,
                             std::vector<Answer> answers);

}  // namespace grade::textbook
