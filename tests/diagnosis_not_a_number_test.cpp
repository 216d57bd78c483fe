#include <cmath>

#include "catch.h"
#include "diagnosis/not_a_number.h"
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
