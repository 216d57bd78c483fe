#include "textbook/operators.h"

#include <algorithm>
#include <set>

#include "textbook/tokens.h"

namespace grade::textbook {

const std::map<std::string, Operator>& operators() {
    static const std::map<std::string, Operator> all{
        {"||", {1, "", {"&&"}}},
        {"&&", {2, "", {"||"}}},
        {"==", {3, "std::equal_to<>, std::not_equal_to<>", {"!="}}},
        {"!=", {3, "std::not_equal_to<>, std::equal_to<>", {"=="}}},
        {"<", {4, "std::less<>, std::less_equal<>, std::greater<>", {"<=", ">"}}},
        {">", {4, "std::greater<>, std::greater_equal<>, std::less<>", {">=", "<"}}},
        {"<=", {4, "std::less_equal<>, std::less<>, std::greater_equal<>", {"<", ">="}}},
        {">=", {4, "std::greater_equal<>, std::greater<>, std::less_equal<>", {">", "<="}}},
        {"+", {5, "std::plus<>, std::minus<>, std::multiplies<>", {"-", "*"}}},
        {"-", {5, "std::minus<>, std::plus<>, std::multiplies<>, textbook::Reversed<std::minus<>>", {"+", "*"}}},
        {"*", {6, "std::multiplies<>, textbook::Quotient, std::plus<>, std::minus<>, textbook::Dot", {"/", "+", "-"}}},
        {"/",
         {6,
          "textbook::Quotient, std::multiplies<>, std::minus<>, textbook::Reversed<textbook::Quotient>",
          {"*", "-"}}},
        {"%", {6, "textbook::Rest, textbook::Quotient", {"/"}}},
    };
    return all;
}

int loosest(const std::string& expression) {
    const std::vector<Token> tokens = tokens_of(expression);
    int level = 100, depth = 0;
    for (std::size_t i = 1; i < tokens.size(); ++i) {
        const std::string& before = tokens[i - 1].text;
        depth += (before == "(" || before == "[" || before == "{") - (before == ")" || before == "]" || before == "}");
        const bool is_behind_value = tokens[i - 1].kind != Token::Kind::sign || before == ")" || before == "]";
        const auto found = operators().find(tokens[i].text);
        if (depth == 0 && is_behind_value && found != operators().end()) level = std::min(level, found->second.level);
    }
    return level;
}

std::vector<std::string> functions_for(const std::string& name) {
    static const std::map<std::string, std::vector<std::string>> all{
        {"sin", {"cos", "tan"}},   {"cos", {"sin"}},
        {"tan", {"sin", "atan"}},  {"min", {"max"}},
        {"max", {"min"}},          {"floor", {"ceil", "round"}},
        {"ceil", {"floor"}},       {"acos", {"asin", "cos"}},
        {"asin", {"acos", "sin"}}, {"log", {"exp", "log2", "log10"}},
        {"exp", {"log"}},          {"log2", {"log"}},
        {"log10", {"log"}},        {"exp2", {"exp"}},
        {"round", {"floor"}},      {"trunc", {"floor"}},
        {"atan", {"tan"}},         {"cbrt", {"sqrt"}},
        {"fmin", {"fmax"}},        {"fmax", {"fmin"}},
    };
    constexpr std::string_view standard = "std::";
    const bool is_standard = name.starts_with(standard);
    const auto found = all.find(is_standard ? name.substr(standard.size()) : name);
    // without std::, there may be no max beside a min
    if (found == all.end() || (!is_standard && found->second.front().starts_with("m"))) return {};
    std::vector<std::string> others = found->second;
    if (is_standard)
        for (std::string& other : others) other.insert(0, standard);
    return others;
}

bool is_cross_product(const std::string& name) {
    return name == "cross" || name == "glm::cross" || name == "rt::cross";
}

bool is_jump(const std::string& statement) { return statement == "break" || statement == "continue"; }

std::string short_name(const std::string& name) {
    return name.starts_with("std::") || name.starts_with("glm::") ? name.substr(5) : name;
}

bool is_number_type(const std::string& name) {
    static const std::set<std::string> all{"Real", "double", "float", "int", "unsigned", "long", "std::size_t"};
    return all.contains(name);
}

std::string function_of(const std::string& sign) {
    const std::string names = operators().at(sign).name;
    return names.substr(0, names.find(','));
}

}  // namespace grade::textbook
