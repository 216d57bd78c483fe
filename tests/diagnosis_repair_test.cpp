

#include "diagnosis/calls/calls_made.h"
#include "diagnosis/samples/integrals.h"
#include "diagnosis/source/borrowed.h"
#include "diagnosis/source/repair.h"
#include "explained.h"
#include "textbook/edits.h"
#include "textbook/in_double.h"
#include "textbook/source.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::StartsWith;

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

TEST_CASE("what a textbook has, in words of arguments and of the answer") {
    const Ask right = answers("phong_lobe");
    const Rows rows = calls([](Generator& random) { return row(between(random, 1, 9), square(random)); });
    const Calls all = compared(declared("phong_lobe"), rows, right, right);
    const Borrowed borrowed(all);
    const Row values = borrowed.values(all.rows[0], all.layouts[0]);
    std::size_t at = 0;
    bool has_power = false;
    for (const auto& expression : borrowed.all()) {
        const double power = std::pow(all.right[0][2], all.rows[0][0]);  // of the direction's z
        if (expression.words == "pow(direction.z, exponent)") has_power = std::abs(values[at] - power) < 1e-9;
        // the whole answer would be no hint
        CHECK(std::abs(values[at] - all.right[0][3]) > 1e-9);
        at += expression.is_vector ? 3 : 1;
    }
    CHECK(has_power);
    CHECK(at == values.size());
    CHECK(Borrowed(Calls{}).all().empty());
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

TEST_CASE("a change is told where it holds in further calls as well, and nowhere breaks a right one") {
    const Rows rows = calls([](Generator& random) { return row(between(random, 0.5, 3), between(random, 0.1, 0.9)); });
    const Flight flight{-1, 2};
    Calls all = compared(declared("free_flight"), rows, flight.ask(), answers("free_flight"));
    all.told.assign(all.layouts.front().parts.size(), true);
    Editable source = flight.editable();
    source.further = [all] { return all; };
    CHECK(repair_of(all, source, true));
    Calls other = all;
    other.right.back()[0] *= 2;
    source.further = [other] { return other; };
    CHECK_FALSE(repair_of(all, source, true));
}
