#include "catch.h"
#include "checks/kit/check.h"
#include "checks/kit/estimate.h"
#include "checks/kit/formula.h"
#include "statistics/moments.h"

using namespace grade;

namespace {

/// Observations of a fragment that doubles its argument, or does something else.
Observation observe(double (*fragment)(double)) {
    Observation seen;
    for (int k = -20; k < 20; ++k) {
        seen.inputs.push_back({double(k)});
        seen.outputs.push_back({fragment(k)});
    }
    return seen;
}

double doubled(double x) { return 2 * x; }

Statistic doubling() {
    return formula<doubled>({.id = "X",
                             .what = "off by",
                             .tolerance = 1e-6,
                             .right = doubled,
                             .suspects = {{"the factor is 3", [](double x, double) { return x + x / 2; }},
                                          {"the result is nan", [](double) { return NAN; }}},
                             .circumstances = {{"negative numbers alone are wrong", [](double x) { return x < 0; }}}});
}

}  // namespace

TEST_CASE("a formula is measured by its worst row, and its cause is the suspect or the circumstance that fits") {
    const Statistic s = doubling();
    CHECK(s.measure(observe([](double x) { return x + x; })) == 0);
    CHECK(s.measure(observe([](double x) { return 3 * x; })) == Approx(1 / 3.));
    CHECK(s.cause(observe([](double x) { return 3 * x; })).words == "the factor is 3");
    CHECK(std::isnan(s.measure(observe([](double) { return double(NAN); }))));
    CHECK(s.cause(observe([](double) { return double(NAN); })).words == "the result is nan");
    CHECK(s.cause(observe([](double x) { return x < 0 ? 5 : 2 * x; })).words.find("negative numbers alone are wrong") ==
          0);
    CHECK(s.cause(observe([](double x) { return x * x + 2; })).numbers.find("40 of 40 calls are wrong") == 0);
}

TEST_CASE("a hint names the nearest known cause, and those that nothing tells apart from it") {
    const Hint hint = by_ratio(
        "the disc",
        {{2, "is the diameter the radius?"}, {2.01, "is it doubled?"}, {2.4, "is it more?"}, {0, "is it missing?"}},
        "look at it");
    CHECK(hint(2.02, 1) == "the disc is 2.02 times what it must be: is it doubled? Or: is the diameter the radius?");
    CHECK(hint(4.8, 2) == "the disc is 2.4 times what it must be: is it more?");
    CHECK(hint(0, 1) == "the disc is 0 times what it must be: is it missing?");
    CHECK(hint(3, 1) == "the disc is 3 times what it must be: look at it");
    CHECK(by_value("x", {{1, "one?"}, {1.01, "one?"}}, 0.1)(1, 0) == "x is 1, not 0: one?");
}

TEST_CASE("chi-squared of even points is 1 on average, and large where a part gets nothing") {
    Generator random(3);
    std::uniform_real_distribution<double> u(0, 1);
    const Statistic s = uniform_in_square(
        {.point = [](const Row&, const Row& out) { return rt::vec2(out[0], out[1]); }, .columns = 4, .rows = 4});
    const auto seen = [&](double width) {
        Observation o;
        for (int k = 0; k < 500; ++k) {
            const double x = u(random), y = u(random);
            o.inputs.push_back({});
            o.outputs.push_back({width * x, y});
        }
        return o;
    };
    Moments even;
    for (int k = 0; k < 400; ++k) even.add(s.measure(seen(1)));
    CHECK(even.mean == Approx(1).margin(4 * even.standard_error()));
    CHECK(s.measure(seen(0.5)) > 10);
    CHECK(s.measure(seen(1.5)) > 10);
}

TEST_CASE("how far answers are off is a share of the larger one: never 1000 where nothing is right") {
    CHECK(deviation({1}, {0}) == 1);
    CHECK(deviation({1}, {1 + 1e-4}) == Approx(1e-4).epsilon(1e-3));
    CHECK(deviation({-1}, {1}) == 2);
    CHECK(deviation({1e-6}, {0}) == Approx(1e-3));
    CHECK(deviation({rt::inf}, {1}) == rt::inf);
    CHECK(deviation({rt::inf}, {rt::inf}) == 0);
    CHECK(std::isnan(deviation({NAN}, {1})));
}

TEST_CASE("of answers that are right or wrong the wrong ones are counted") {
    const Statistic wrong =
        formula(RowFormula{.id = "F1", .what = "wrong answers", .right = [](const Row& in) { return in; }});
    Observation seen;
    seen.inputs = {{0}, {1}, {1}, {0}}, seen.outputs = {{0}, {0}, {0}, {0}};
    CHECK(wrong.measure(seen) == 2);
}

TEST_CASE("of several mistakes that give nearly all answers, the one that gives most is told") {
    RowFormula squares{
        .id = "F1", .what = "off by", .tolerance = 1e-6, .right = [](const Row& in) { return Row{in[0] * in[0]}; }};
    squares.suspects = {{"it is 1 more", [](const Row& in, const Row& right) { return Row{right[0] + (in[0] != 7)}; }},
                        {"it is 1 more, at 7 as well", [](const Row&, const Row& right) { return Row{right[0] + 1}; }}};
    const Statistic off = formula(squares);
    Observation seen;
    for (int x = 0; x < 200; ++x) seen.inputs.push_back({double(x)}), seen.outputs.push_back({x * x + 1.0});
    REQUIRE(off.cause);
    CHECK(off.cause(seen).words == "it is 1 more, at 7 as well");
}
