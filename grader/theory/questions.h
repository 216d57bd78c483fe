#pragma once

#include <string>
#include <vector>

namespace grade {

/// A question with a closed answer, about numbers that belong to a name.
struct Question {
    std::string key;              // of theory.toml
    std::string text;             // with the numbers
    std::string unit;             // of the answer; empty: a plain number
    std::vector<double> numbers;  // in the order of the text
    double answer = 0;
    std::string worked;  // the way to the answer, with the numbers
};

/// The eight questions, with the numbers of a name. Names that differ in spaces or in the case of Latin letters alone
/// have the same numbers.
std::vector<Question> questions_of(const std::string& name);

}  // namespace grade
