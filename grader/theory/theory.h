#pragma once

#include <optional>
#include <string>
#include <vector>

#include "theory/questions.h"

/// theory.toml: a name, and an answer to each question of questions.h.
namespace grade {

struct Answered {
    Question question;
    std::optional<double> answer;
    bool right = false;  // within a hundredth
};

struct Theory {
    std::string name;
    std::vector<Answered> answers;  // in the order of the questions

    int right() const;
};

/// A file for this name: the questions as comments, the answers to be filled in. Throws rt::InputError for what is no
/// name.
std::string empty_theory(const std::string& typed);

/// Throws rt::InputError, with line and column.
Theory read_theory(const std::string& text, const std::string& path);

/// For the terminal: each question and what became of it. One that is right is followed by the way to it; one that is
/// wrong by the way to the answer for other numbers, those of another name.
std::string told(const Theory& theory, double points);

}  // namespace grade
