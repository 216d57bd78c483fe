#include <stdexcept>

#include "student_source.h"
#include "textbook/edits.h"
#include "textbook/in_double.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

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

TEST_CASE("a student's source: a vector's length() may be meant to be its length") {
    const auto source = textbook::editable(function("    return u.length() + x;\n"));
    CHECK(node(source, "u.length()").alternatives == std::vector<std::string>{"length(u)"});
    CHECK_THAT(source.text, ContainsSubstring("textbook::length_of("));
    const rt::vec2 u(3, 4);
    const auto length_with = [&](int alternative) {
        const textbook::Mistake mistake{{0}, alternative};
        textbook::watch.begin(0, 1, {}, &mistake, nullptr);
        return textbook::length_of(0, u);
    };
    CHECK(length_with(0) == 2);
    CHECK(length_with(1) == 5);
    CHECK(textbook::length_of(0, std::string("four")) == 4);  // what is no vector stays as it is
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
