#include "diagnosis/changes/constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rt/math.h"

namespace grade {

namespace {

struct Named {
    double value;
    const char* words;
};

constexpr Named constants[] = {{1, "1"},
                               {2, "2"},
                               {3, "3"},
                               {4, "4"},
                               {8, "8"},
                               {rt::pi, "pi"},
                               {2 * rt::pi, "2 pi"},
                               {4 * rt::pi, "4 pi"},
                               {rt::pi / 2, "pi / 2"},
                               {rt::pi * rt::pi, "pi^2"},
                               {180 / rt::pi, "180 / pi"},
                               {1.4142135623730951, "sqrt(2)"},
                               {1.7320508075688772, "sqrt(3)"},
                               {2.302585092994046, "log(10)"},
                               {0.6931471805599453, "log(2)"},
                               {1.5, "3 / 2"}};

}  // namespace

std::string ratio_in_words(double ratio) {
    const double off = std::abs(ratio - 1);
    const int digits = off > 0 && off < 0.5 ? int(std::ceil(-std::log10(off))) + 2 : 3;
    return fmt::format("{:.{}g}", ratio, std::clamp(digits, 3, 12));
}

std::string constant(double x) {
    if (x < 0) return "-" + constant(-x);
    if (x == 0) return "0";
    for (const auto& [value, words] : constants) {
        if (std::abs(x / value - 1) < 3e-5) return words;
        const std::string name = words;
        if (std::abs(x * value - 1) < 3e-5) return "1 / " + (name.find(' ') == name.npos ? name : "(" + name + ")");
    }
    return ratio_in_words(x);
}

bool is_named(double x) {
    return std::ranges::any_of(constants, [=](const Named& n) {
        return std::abs(std::abs(x) / n.value - 1) < 3e-5 || std::abs(std::abs(x) * n.value - 1) < 3e-5;
    });
}

}  // namespace grade
