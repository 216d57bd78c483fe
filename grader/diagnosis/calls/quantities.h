#pragma once

#include <functional>
#include <optional>

#include "diagnosis/calls/arguments.h"

namespace grade {

/// A number of the arguments that a formula may hold: an argument, a length, a dot product, a distance.
struct Quantity {
    enum class Kind { number, length, product, coordinate };  // but for a number, of vectors or of the answer
    std::string words;
    std::function<double(const Row& row, const Layout& layout, const Row& output)> value;
    Kind kind = Kind::number;
    std::string vector{};                    // whose length it is
    std::optional<std::size_t> answer_at{};  // where the part of the answer stands that it is, or the length of
};

/// With result, those that the direction or point of the fragment's own answer is part of as well.
std::vector<Quantity> quantities_of(const Layout& layout, const std::vector<bool>& told,
                                    const Layout* result = nullptr);

/// With lengths as they are written in a source, and their squares.
std::vector<Quantity> as_code(std::vector<Quantity> all);

}  // namespace grade
