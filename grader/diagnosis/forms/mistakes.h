#pragma once

#include <span>

#include "diagnosis/changes/changes.h"
#include "textbook/node.h"
#include "textbook/watch.h"

/// What is done wrong in one expression of a formula.
namespace grade {

/// A value that can stand in another's place.
struct OtherValue {
    std::string name;
    textbook::Value::Kind kind;
    int node = -1;       // in the form; -1: an argument
    std::size_t at = 0;  // in the row of arguments
    bool is_color = false;
};

struct Mistake {
    std::string pattern;       // {0}: what is written, {1}: the other value; of an alternative, its text
    const char* usually = "";  // what that is in most code
    double cost = 0;           // the simpler, the less
    textbook::Mistake made{};
    std::string other{};                   // the name of the other value
    const Change* of_arguments = nullptr;  // in place of one in an expression
};

/// Expressions, and what kinds of values they were seen to have.
struct Expressions {
    std::span<const textbook::Node> nodes;
    int first = 0;                              // the number of the first
    std::vector<textbook::Value::Kind> seen{};  // none: never computed

    const textbook::Node& node(int number) const { return nodes[std::size_t(number - first)]; }
    /// Whether an expression is a part of another, or of a part of it.
    bool holds(int whole, int node) const;
    /// Whether two mistakes are in one place, or one within the other's.
    bool overlap(const textbook::Mistake& a, const textbook::Mistake& b) const;
};

/// Mistakes in these that make sense for such arguments, the simplest first.
std::vector<Mistake> mistakes_in(const Expressions& all, const Layout& arguments, const std::vector<bool>& told);

/// "2 * x" for "x"; what stands there, "x".
std::string changed_in_words(const Expressions& all, const Mistake& mistake);
std::string written_in_words(const Expressions& all, const Mistake& mistake);

/// "the second " of several alike, in one statement, or in all of its line; empty: there is one.
std::string which_in_words(const Expressions& all, const Mistake& mistake, bool in_statement);

}  // namespace grade
