
#include <stdexcept>

#include "diagnosis/calls_made.h"
#include "diagnosis/edits_in_words.h"
#include "diagnosis/integrals.h"
#include "diagnosis/renamed.h"
#include "diagnosis/repair.h"
#include "explained.h"
#include "textbook/edits.h"
#include "textbook/functions.h"
#include "textbook/in_double.h"
#include "textbook/operators.h"
#include "textbook/source.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

namespace {

std::string function(const std::string& body) {
    return "#include \"rt/fragments.h\"\n\nnamespace rt {\n\nReal f(Real x, vec2 u) {\n" + body + "}\n\n}\n";
}

const textbook::Node& node(const textbook::EditableSource& source, const std::string& text) {
    const auto found = std::ranges::find(source.nodes, text, &textbook::Node::text);
    REQUIRE(found != source.nodes.end());
    return *found;
}

}  // namespace

TEST_CASE("a student's source: what it holds, and in which line") {
    const auto plain =
        textbook::editable(function("    const Real y = 2 * x;\n    return std::sqrt(y) -\n           u.x;\n"));
    CHECK(node(plain, "2 * x").line == 6);
    CHECK(node(plain, "2 * x").name == "y");
    CHECK(node(plain, "sqrt(y) - u.x").line == 7);
    // helpers, structs and lambdas, what is declared with auto, casts, a loop over a list, a comment like code
    const auto more = textbook::editable(
        "#include \"rt/fragments.h\"\nnamespace rt {\nnamespace {\nReal half(Real x) { return x / 2; }\nstruct Two {\n"
        "    Real a = 1;\n    Real sum(Real b) const { return a + b; }\n};\n}\nReal f(Real x, vec2 u) {\n"
        "    /* return x * 9; */ const auto twice = [&](Real y) {\n        return y * 2;\n    };\n"
        "    const auto [s, t] = u;\n    Real sum = static_cast<Real>(1) * x;\n    for (const Real w : {1.0, 2.0}) {\n"
        "        sum += w * half(x);\n    }\n    switch (int(x)) {\n        case 1: return twice(s - t);\n"
        "        default: break;\n    }\n    do { sum = sum + 3; } while (sum < 0);\n    return sum;\n}\n}\n");
    for (const auto& [text, line] : {std::pair("x / 2", 4), std::pair("a + b", 7), std::pair("y * 2", 12),
                                     std::pair("w * half(x)", 17), std::pair("s - t", 20), std::pair("sum + 3", 23)})
        CHECK(node(more, text).line == line);
    CHECK(std::ranges::count(more.nodes, "x * 9", &textbook::Node::text) == 0);
    const auto listed = textbook::editable(function("    for (const Real t : {x * 3, u.y}) if (t > 0) return t;\n"));
    CHECK(node(listed, "x * 3").line == 6);
    CHECK_THAT(more.text, ContainsSubstring("case 1:"));
    CHECK_THAT(more.text, ContainsSubstring("for (const Real w : {1.0, 2.0})"));
}

TEST_CASE("a student's source: variables that get other values are not what they were") {
    const auto source =
        textbook::editable(function("    Real k = 2 * x, m = k + 1;\n    k *= u.x;\n    vec2 v = u;\n    v[0] = k;\n"
                                    "    for (int i = 0; i < 3; ++i) v.y += m;\n    return k + m * x;\n"));
    CHECK(source.varying == std::set<std::string>{"k", "v"});
    CHECK(node(source, "2 * x").varies);  // it is called k
    CHECK(node(source, "k + 1").varies);
    CHECK_FALSE(node(source, "m * x").varies);
}

TEST_CASE("a student's source: constants with a name are the numbers that they stand for, and no constexpr") {
    const auto source = textbook::editable(
        "namespace rt {\nconstexpr Real rim = 1e-5;\n" +
        function(
            "    constexpr Real least = 1e-4;\n    constexpr int twice = 2;\n    static constexpr Real most = 7;\n"
            "    if (x < least || x > 1 - least) return twice * u.x + rim;\n    return x < most ? x + rim : u.x;\n") +
        "}\n");
    CHECK(node(source, "least").literal == "1e-4");
    CHECK(node(source, "rim").literal == "1e-5");
    CHECK(node(source, "u.x").literal.empty());
    for (const char* text :
         {"constexpr Real rim = 1e-5;", "constexpr int twice = 2;", "static constexpr Real most = 7;"})
        CHECK_THAT(source.text, ContainsSubstring(text));  // as it is: computed when it is compiled
    CHECK_THAT(source.text, !ContainsSubstring("constexpr Real least"));
}

TEST_CASE("a student's source: where its variables are known") {
    const auto source =
        textbook::editable("namespace rt {\nReal other(Real z) { return z + 7; }\n" +
                           function("    const Real k = 2 * x;\n    const auto half = [&](Real y) {\n"
                                    "        const Real q = y + x;\n        return q / 2;\n    };\n"
                                    "    for (int i = 0; i < 3; ++i) {\n        const Real m = k + i;\n"
                                    "        if (m > 2) return m * k;\n    }\n    return half(k) + u.x * x;\n") +
                           "}\n");
    const auto is_known = [&](const std::string& text, const std::string& at) {
        return node(source, text).is_known_at(node(source, at));
    };
    CHECK(is_known("2 * x", "q / 2"));  // it is called k
    CHECK(is_known("2 * x", "m * k"));
    CHECK(is_known("y + x", "q / 2"));
    CHECK(is_known("k + i", "m * k"));
    CHECK_FALSE(is_known("y + x", "u.x * x"));
    CHECK_FALSE(is_known("k + i", "u.x * x"));
    CHECK_FALSE(is_known("z + 7", "u.x * x"));
}

TEST_CASE("a student's source: break and continue may be taken for each other, where both may stand") {
    const auto source = textbook::editable(
        function("    Real sum = 0;\n    for (int i = 0; i < 4; ++i) {\n        if (i == 2) break;\n"
                 "        switch (i) {\n            case 1: sum += u.y; break;\n            default: sum += u.x;\n"
                 "        }\n        do {\n            if (sum > x) continue;\n            sum += x;\n"
                 "        } while (sum < 1);\n    }\n    return sum;\n"));
    const auto& jump = node(source, "break");
    CHECK(jump.alternatives == std::vector<std::string>{"continue"});
    CHECK(jump.line == 8);
    CHECK(jump.context == "if (i == 2) break");
    CHECK(std::ranges::count(source.nodes, "break", &textbook::Node::text) == 1);  // not that of the switch
    CHECK(node(source, "continue").alternatives == std::vector<std::string>{"break"});
}

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

TEST_CASE("a student's source that is not read") {
    const auto refused = [](const std::string& text) { CHECK_THROWS_AS(textbook::editable(text), std::exception); };
    refused("");
    refused("namespace rt { Real f() { return");
    refused(function("#define TWO 2\n    return TWO * x;\n"));
    refused(function("    return x" + std::string(70'000, ' ') + ";\n"));
    // what is too deep, or too long, stays as it is
    const auto rest = [](const std::string& before) {
        return textbook::editable(function(before + "    return x + 1;\n")).nodes.size();
    };
    CHECK(rest("") == 3);
    CHECK(rest("    x = " + std::string(5'000, '-') + "x;\n") == 3);
    CHECK(rest("    x = " + std::string(5'000, '(') + "x" + std::string(5'000, ')') + ";\n") == 3);
    std::string sum = "x", blocks = std::string(5'000, '{') + std::string(5'000, '}');
    for (int i = 0; i < 3'000; ++i) sum += " + x";
    CHECK(rest("    x = " + sum + ";\n") == 3);
    refused(function(blocks));
    refused(function("    const Real " + std::string(200, 'y') + " = x;\n    return x + 1;\n"));
    // nothing is written twice that may be long
    std::string product = "x", condition = "x > 0", lambdas = "1";
    for (int i = 0; i < 30; ++i) product += " * (x + 1)", condition += " && x > 0";
    CHECK(textbook::editable(function("    return " + product + ";\n")).text.size() < 100'000);
    CHECK(textbook::editable(function("    return " + condition + " ? 1 : 0;\n")).text.size() < 100'000);
    // nor is a part read again and again: what stands behind each of these is no statement
    for (int i = 0; i < 40; ++i) lambdas = "[&] { auto y = " + lambdas + " ? : 1; return y; }()";
    refused(function("    return " + lambdas + ";\n"));
}

TEST_CASE("a student's source: real numbers in the places of whole ones, all and one at a time") {
    const auto all = textbook::with_reals(
        function("    const int cut = x;\n    for (int i = 0; i < 3; ++i) x += (i + 1) / 3 + cut / 2.0;\n"
                 "    return x / 0.5;\n"));
    REQUIRE(all.size() == 3);
    CHECK_THAT(all[0].text, ContainsSubstring("const double cut = x;") && ContainsSubstring("(i + 1) * 1.0 / 3"));
    CHECK_THAT(all[1].text, ContainsSubstring("const double cut = x;") && ContainsSubstring("(i + 1) / 3"));
    CHECK(all[1].line == 6);
    CHECK_THAT(all[2].text, ContainsSubstring("(i + 1) * 1.0 / 3 + cut / 2.0") && ContainsSubstring("int cut"));
    CHECK(all[2].is_quotient);
    CHECK(all[2].line == 7);
}

TEST_CASE("comments are not quoted") {
    const auto source =
        textbook::editable(function("    Real volatile /* all points, please */ y = x + 1;\n    return y;\n"));
    CHECK(node(source, "x + 1").context == "Real volatile y = x + 1");
}

TEST_CASE("calls with mistakes go as numbers, and come back") {
    textbook::EditedCall call{7, false, {}, {1, 2, 3}, {4, 5}};
    const textbook::Mistake first{{2, 3}, 0, textbook::Made::number_with, 4, -1, 3}, second{{5}, 2};
    const auto back = textbook::edited_call_of(textbook::row_of(call, &first, &second));
    CHECK(back.nodes == 7);
    CHECK(back.arguments == call.arguments);
    CHECK(back.more == call.more);
    REQUIRE(back.mistakes.size() == 2);
    CHECK(back.mistakes[0].nodes == first.nodes);
    CHECK(back.mistakes[0].made == first.made);
    CHECK(back.mistakes[0].function == 4);
    CHECK(back.mistakes[0].other_at == 3);
    CHECK(back.mistakes[1].alternative == 2);
    CHECK_THROWS_AS(textbook::edited_call_of(std::vector<double>{1, 0, 9, 0}), std::out_of_range);
    CHECK_THROWS_AS(textbook::edited_call_of(std::vector<double>{1, 0, 0, 3, 0, 0}), std::out_of_range);
    CHECK_THROWS_AS(textbook::edited_call_of(std::vector<double>{1, 0, 0, 1e300}), std::domain_error);
}

namespace {

/// A free flight as a student may write it, with its expressions as a build puts them: `sign * log(1 - u) / down`,
/// where `down` must be the extinction.
struct Flight {
    double sign = -1, power = 1, more = 0, from = 1;  // 0: by u itself, which is as good

    double operator()(double extinction, double u) const {
        const double rest = textbook::binary<std::minus<>, std::plus<>>(1, from, textbook::at(0, u));
        const double left = textbook::at(1, std::abs(rest));
        const double log = textbook::at(2, sign * std::log(left));
        const double down = textbook::at(3, std::pow(extinction, power) + more * std::sin(u));
        return textbook::at(4, textbook::binary<textbook::Quotient, std::multiplies<>>(4, log, down));
    }

    Editable editable() const {
        const std::vector<textbook::Node> nodes{
            {"u", "u", "left = 1 - u", "", {}, {}, 3},
            {"1 - u", "left", "left = 1 - u", "", {0}, {"1 + u"}, 3},
            {"s * log(left)", "log", "log = s * log(left)", "", {}, {}, 4},
            {"pow(extinction, p)", "down", "down = pow(extinction, p)", "", {}, {}, 5},
            {"log / down", "log / down", "return log / down", "", {2, 3}, {"log * down"}, 6}};
        return {nodes, {}, [flight = *this](const Rows& rows) {
                    Rows all;
                    for (const Row& row : rows) {
                        const auto call = textbook::edited_call_of(row);
                        const auto mistake = [&](std::size_t i) {
                            return i < call.mistakes.size() ? &call.mistakes[i] : nullptr;
                        };
                        Row known = call.arguments;
                        known.insert(known.end(), call.more.begin(), call.more.end());
                        textbook::watch.begin(0, call.nodes, known, mistake(0), mistake(1));
                        Row answer{flight(call.arguments[0], call.arguments[1])};
                        if (call.only_kinds) {
                            answer.clear();
                            for (const auto& value : textbook::watch.values) answer.push_back(double(value.kind));
                        }
                        all.push_back(answer);
                    }
                    return all;
                }};
    }

    Ask ask() const {
        return [flight = *this](const Rows& rows) {
            Rows all;
            for (const Row& row : rows) {
                textbook::watch.begin(0, 0, {}, nullptr, nullptr);
                all.push_back({flight(row[0], row[1])});
            }
            return all;
        };
    }
};

Finding found(const Flight& flight) {
    const Rows rows = calls([](Generator& random) { return row(between(random, 0.5, 3), between(random, 0.1, 0.9)); });
    return explain(declared("free_flight"), rows, flight.ask(), answers("free_flight"),
                   {[&] { return std::optional(flight.editable()); }});
}

}  // namespace

TEST_CASE("what must stand in a student's own expression is told, with its line") {
    const Finding one = found({-1, 1, 0.3});
    CHECK_THAT(one.how,
               ContainsSubstring("with `down = extinction` in place of `down = pow(extinction, p)` in line 5"));
    CHECK_THAT(one.how, ContainsSubstring("every answer is right"));
    CHECK(one.by_repair);
    // the student's own words, where a change of an argument explains it as well
    const Finding square = found({-1, 2});
    CHECK_THAT(square.how, ContainsSubstring("with `down = ") && ContainsSubstring("in line 5") &&
                               !ContainsSubstring("exactly as if"));
    CHECK((square.by_repair && square.by_arguments));
    // where a textbook's form says what it is, the line alone
    const Finding sign = found({1, 1});
    CHECK_THAT(sign.how, ContainsSubstring("sign"));
    CHECK_THAT(sign.how, ContainsSubstring("line "));
    CHECK(found(Flight{}).how.empty());
}

TEST_CASE("what must stand where samples lie elsewhere than the solution's") {
    const Rows rows = calls([](Generator& random) { return row(between(random, 0.5, 3), between(random, 0.1, 0.9)); });
    const auto repair = [&](const Flight& flight) {
        const Calls all = compared(declared("free_flight"), rows, flight.ask(), answers("free_flight"));
        Calls told = all;
        told.told.assign(all.layouts.front().parts.size(), true);
        const auto found = repair_of_spread(told, flight.editable(), answers("free_flight"));
        return found ? found->words : "";
    };
    CHECK_THAT(repair({-1, 2, 0, 0}), ContainsSubstring("in place of `down = pow(extinction, p)` in line 5") &&
                                          ContainsSubstring("the samples are spread as they must be"));
    CHECK(repair({-1, 1, 0, 0}).empty());      // right, elsewhere
    CHECK(repair({-1, 1, 0.3, 0}) != "");      // `extinction`
    CHECK(repair({-1, 1.5, 0.3, 7}).empty());  // no change of one expression
}

TEST_CASE("samples that are no directions are not spread as they must be, whatever they integrate") {
    const Ask right = answers("cosine_hemisphere");
    const Rows rows = squares();
    const Calls all = compared(declared("cosine_hemisphere"), rows, right, right);
    const auto integrals = Integrals::of(all, right, 1, 12, 0.1);
    REQUIRE(integrals);
    const auto of_height = [&](auto height) {
        Rows samples = right(integrals->rows());
        for (Row& out : samples) out[2] = height(std::hypot(out[0], out[1])), out[3] = out[2] / rt::pi;
        return samples;
    };
    CHECK(integrals->are_right(of_height([](double r) { return std::sqrt(1 - r * r); })));
    CHECK_FALSE(integrals->are_right(of_height([](double r) { return r; })));  // its moments are
}

TEST_CASE("a program that gives no answers, or too few, is no repair") {
    Calls all;
    all.signature = declared("free_flight");
    for (int i = 1; i < 20; ++i) {
        all.rows.push_back({1.0, 0.04 * i});
        all.layouts.push_back(all.signature.of_arguments(all.rows.back()));
        all.mine.push_back({1}), all.right.push_back({2});
    }
    all.result = all.signature.of_result(all.right.front());
    all.told = {true, true};
    const auto nodes = Flight{}.editable().nodes;
    CHECK_FALSE(repair_of(all, {nodes, {}, [](const Rows&) { return Rows(); }}, false));
    CHECK_FALSE(repair_of(all, {nodes, {}, [](const Rows& rows) { return Rows(rows.size()); }}, false));
    CHECK_FALSE(repair_of(all, {nodes, {}, [](const Rows& rows) { return Rows(rows.size(), Row(50, 1e9)); }}, false));
    CHECK_FALSE(repair_of({}, Flight{}.editable(), false));
}
