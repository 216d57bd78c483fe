#pragma once

#include <functional>

#include "diagnosis/arguments.h"

namespace grade {

/// A number of the arguments that a formula may hold: an argument, a length, a dot product, a distance.
struct Quantity {
    std::string words;
    std::function<double(const Row& row, const Layout& layout, const Row& output)> value;
};

/// With result, those that the direction or point of the fragment's own answer is part of as well.
std::vector<Quantity> quantities_of(const Layout& layout, const std::vector<bool>& told,
                                    const Layout* result = nullptr);

}  // namespace grade
