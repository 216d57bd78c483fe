#include "diagnosis/source/edits_in_words.h"
#include "diagnosis/source/renamed.h"
#include "student_source.h"
#include "textbook/functions.h"
#include "textbook/operators.h"

using namespace grade;
using Catch::Matchers::StartsWith;

TEST_CASE("another operator in place of one has the brackets that it needs") {
    const auto source =
        textbook::editable(function("    const bool a = x > 1, b = x > 2, c = x > 3;\n"
                                    "    return a || b || c ? 1 - u.x * u.x * (1 - x) : 0;\n"));
    CHECK(node(source, "a || b || c").alternatives.front() == "(a || b) && c");
    const auto has = [](const textbook::Node& node, const std::string& alternative) {
        return std::ranges::count(node.alternatives, alternative) == 1;
    };
    const auto sums = textbook::editable(function("    return (x - x * u.x) * (x / u.y + x) * ((x - 1) * u.x);\n"));
    CHECK(has(node(sums, "x - x * u.x"), "(x - x) * u.x"));  // brackets that are missing
    CHECK(has(node(sums, "x / u.y + x"), "x / (u.y + x)"));
    CHECK(has(node(sums, "(x - 1) * u.x"), "x - 1 * u.x"));  // and too many
    CHECK(textbook::loosest("a * (b + c)") == textbook::loosest("a * b"));
    CHECK(textbook::loosest("a * -b + f(c, d)") == textbook::loosest("a - b"));
    CHECK(textbook::loosest("(a + b)") == textbook::loosest("a"));
}

TEST_CASE("a change of an operand is told as one of the whole, where that reads better") {
    const auto told = [](const std::string& expression, const std::string& part, const std::string& pattern,
                         textbook::Made made, std::size_t function = 0) {
        const auto source =
            textbook::editable(::function("    const Real y = x + u.x;\n    return " + expression + ";\n"));
        const Expressions all{source.nodes, 0};
        Mistake change{pattern};
        const auto at = std::ranges::find(source.nodes, part, &textbook::Node::text) - source.nodes.begin();
        change.made.nodes = {int(at)}, change.made.made = made, change.made.function = function;
        return in_words(all, {&change});
    };
    using textbook::Made;
    const auto index = [](std::string_view words) {
        return std::size_t(std::ranges::find(scalar_functions, words, &Function::words) - std::begin(scalar_functions));
    };
    const auto number = [&](const std::string& expression, const std::string& part, const char* words) {
        return told(expression, part, words, Made::number, index(words));
    };
    CHECK_THAT(number("x + y * y", "y * y", "-{}"), StartsWith("with `x - y * y` in place of `x + y * y` in line 7"));
    CHECK_THAT(number("x - y * y", "y * y", "-{}"), StartsWith("with `x + y * y` in place of `x - y * y`"));
    CHECK_THAT(number("2 * y", "2", "1"), StartsWith("with `y` in place of `2 * y`"));
    CHECK_THAT(number("y / 2", "2", "1"), StartsWith("with `y` in place of `y / 2`"));
    CHECK_THAT(number("2 / y", "2", "1"), StartsWith("with `1 / y` in place of `2 / y`"));
    CHECK_THAT(number("x * y + 2", "2", "{} - 1"), StartsWith("with `x * y + 1` in place of `x * y + 2`"));
    CHECK_THAT(number("x * y + x / y", "x / y", "0"), StartsWith("with `x * y` in place of `x * y + x / y`"));
    CHECK_THAT(number("x * y * x", "x * y", "0"), StartsWith("with `0` in place of `x * y * x`"));
    CHECK_THAT(told("x > y ? x * 2 : y", "x > y", "false", Made::no),
               StartsWith("with `y` in place of `x > y ? x * 2 : y`"));
    CHECK_THAT(told("x > y ? x * 2 : y", "x > y", "true", Made::yes), StartsWith("with `x * 2` in place of `x > y"));
    CHECK_THAT(told("(x > y && u.y < x) * y", "u.y < x", "true", Made::yes),
               StartsWith("with `x > y` in place of `x > y && u.y < x`"));
    // what reads no better
    CHECK_THAT(number("x * y + x", "x * y", "sqrt({})"), StartsWith("with `sqrt(x * y)` in place of `x * y`"));
    CHECK_THAT(number("x * y + 2", "2", "sqrt({})"), StartsWith("with `1.41421` in place of `2`"));
}

TEST_CASE("two names in one expression") {
    const std::string body =
        "    const vec3 a(x), b(u.x), c(u.y);\n    const vec3 e = cross(c - b, b - a), f = cross(a, b + c);\n"
        "    return dot(e, f) * dot(a, c) * dot(b, b);\n";
    const auto source = textbook::editable(::function(body));
    Expressions all{source.nodes, 0};
    const auto change = [&](const std::string& within, std::size_t number, const std::string& other) {
        const auto holder = std::ranges::find(source.nodes, within, &textbook::Node::text);
        Mistake made{"{1}"};
        made.cost = 1, made.other = other, made.made.nodes = {holder->parts.at(number)};
        made.made.made = textbook::Made::vector_with;
        return made;
    };
    const std::vector<Mistake> changes = {change("c - b", 0, "a"), change("c - b", 1, "c"), change("b - a", 1, "c"),
                                          change("b + c", 0, "a")};
    const std::vector<Edit> pairs = renamed(all, changes);
    REQUIRE(pairs.size() == 3);  // of one statement: the last one stands in another
    std::vector<std::string> words;
    for (const Edit& pair : pairs) words.push_back(in_words(all, pair));
    CHECK_THAT(words[0], StartsWith("with `a - c` in place of `c - b` in line 7, `e = "));
    CHECK_THAT(words[1], StartsWith("with `e = cross(a - b, b - c)` in place of `e = cross(c - b, b - a)` in line 7"));
    CHECK(pairs[0].cost() < 1.5);  // one expression, not two changes
}
