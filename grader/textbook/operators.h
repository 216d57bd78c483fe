#pragma once

#include <map>
#include <string>
#include <vector>

/// What is written in place of operators and functions by mistake.
namespace grade::textbook {

struct Operator {
    int level;
    const char* name;                 // its function object, and those of the others, for watched.h
    std::vector<std::string> others;  // in its place; then its sides exchanged, where that is another value
};

/// Those of which the right side may not be computed have no function object.
const std::map<std::string, Operator>& operators();

/// The level of the operator that is applied last in an expression; a large one where there is none.
int loosest(const std::string& expression);

/// The function object of a sign.
std::string function_of(const std::string& sign);

/// What is written in place of a function, qualified as it is.
std::vector<std::string> functions_for(const std::string& name);

/// Whether a function's arguments are likely to be exchanged.
bool is_cross_product(const std::string& name);

/// "break" or "continue"
bool is_jump(const std::string& statement);

/// "sqrt" of "std::sqrt"
std::string short_name(const std::string& name);

/// Whether a name in brackets is that of a cast.
bool is_number_type(const std::string& name);

}  // namespace grade::textbook
