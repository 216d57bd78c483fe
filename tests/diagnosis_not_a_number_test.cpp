#include <cmath>

#include "catch.h"
#include "diagnosis/source/not_a_number.h"
#include "explained.h"
#include "textbook/edits.h"

using namespace grade;

namespace {

textbook::Value number(double x) { return {textbook::Value::Kind::number, {x, 0, 0}}; }

/// t = 0 / (u * 0), which is nan, and what comes of it.
Editable quotient() {
    const std::vector<textbook::Node> nodes{{"u * 0", "below", "below = u * 0", "", {}, {}, 3},
                                            {"1 / below", "over", "over = 1 / below", "", {0}, {}, 4},
                                            {"below * over", "t", "t = below * over", "", {0, 1}, {}, 5},
                                            {"t + 1", "t + 1", "return t + 1", "", {2}, {}, 6}};
    return {nodes, {}, [](const Rows& rows) {
                Rows all;
                for (const Row& row : rows) {
                    const double u = textbook::edited_call_of(row).arguments.back(), below = u * 0, over = 1 / below;
                    all.emplace_back();
                    for (const double x : {below, over, below * over, below * over + 1})
                        all.back().push_back(textbook::seen(number(x)));
                }
                return all;
            }};
}

}  // namespace

TEST_CASE("where nan begins, and what it is made of") {
    Calls calls{declared("free_flight"), {}, {}, {}, {}, {}, {}};
    for (int k = 0; k < 8; ++k) {
        calls.rows.push_back({1, (k + 0.5) / 8}), calls.right.push_back({1});
        calls.mine.push_back({k % 2 ? std::nan("") : 1});
    }
    CHECK(first_not_a_number(calls, quotient()) ==
          "`below * over` in line 5, where `below` is 0 and `over` is infinite");
    for (Row& answer : calls.mine) answer = {1};
    CHECK(first_not_a_number(calls, quotient()).empty());
}

TEST_CASE("where nothing else is wrong, that is told first") {
    const Rows rows = calls([](Generator& random) { return row(between(random, 0.5, 3), between(random, 0.1, 0.9)); });
    const Ask right = answers("free_flight");
    const auto mine = [&](double factor) {
        return [=](const Rows& asked) {
            Rows all = right(asked);
            for (std::size_t k = 0; k < asked.size(); ++k) all[k][0] *= asked[k][1] < 0.4 ? std::nan("") : factor;
            return all;
        };
    };
    const Recompiled source{[] { return std::optional(quotient()); }};
    const Finding alone = explain(declared("free_flight"), rows, mine(1), right, source);
    CHECK(alone.how == "nan begins with `below * over` in line 5, where `below` is 0 and `over` is infinite");
    CHECK(alone.of_nan);
    CHECK_FALSE(explain(declared("free_flight"), rows, mine(2), right, source).of_nan);
}
