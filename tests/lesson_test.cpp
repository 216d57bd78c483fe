#include "lesson/lesson.h"

#include <cmath>

#include "catch.h"

using namespace grade;
using namespace grade::lesson;

namespace {

double integral_of(const Integrand& f) {
    const int n = 100'000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += f((i + 0.5) / n) / n;
    return sum;
}

}  // namespace

TEST_CASE("the lesson's integrals are right, and its densities are densities") {
    for (const LessonIntegrand& one : lesson_integrands()) {
        INFO(one.name);
        CHECK(integral_of(one.f) == Approx(one.integral).epsilon(1e-8));
        CHECK(integral_of(one.density) == Approx(1).epsilon(1e-8));
        CHECK(one.cumulative(0) == Approx(0).margin(1e-12));
        CHECK(one.cumulative(1) == Approx(1).epsilon(1e-12));
        for (double x = 0.01; x < 1; x += 0.0373) {
            INFO("x = " << x);
            CHECK(one.density(x) > 0);
            const double step = 1e-6;
            CHECK((one.cumulative(x + step) - one.cumulative(x - step)) / (2 * step) ==
                  Approx(one.density(x)).epsilon(1e-4));
            CHECK(point_of(one, one.cumulative(x)) == Approx(x).epsilon(1e-6));
        }
    }
}

TEST_CASE("a plot's guides have their slopes, and what is too small stands on its foot") {
    Plot plot{"lines", "x", "y", {{"one", {{1, 1}, {10, 0.1}, {100, 1e-30}}}}};
    plot.guides = {{-1, "N^-1"}};
    plot.least_y = 1e-2;
    // the plot's area is 314 wide and 250 high, from 58, 34
    const std::string svg = log_log(plot);
    INFO(svg);
    CHECK(svg.find("M58.0 34.0L372.0 284.0") != std::string::npos);              // the guide: two decades down in two
    CHECK(svg.find("M58.0 34.0L215.0 159.0L372.0 284.0") != std::string::npos);  // the line
    CHECK(svg.find("1e-30") == std::string::npos);

    CHECK(svg.find("<text x=\"375.0\"") != std::string::npos);  // its name, behind the border

    plot.series[0].joined = false;
    CHECK(log_log(plot).find("M58.0 34.0L215.0 159.0") == std::string::npos);
    plot.series[0].color = 1;
    CHECK(log_log(plot).find("#d55e00") != std::string::npos);
}

TEST_CASE("the name of a guide that ends at the foot stands on no curve") {
    Plot plot{"lines", "x", "y", {{"beside", {{1, 1}, {47, 1e-4}}}, {"further", {{1, 1}, {100, 0.1}}}}};
    plot.guides = {{-2.5, "steep"}};
    const std::string svg = log_log(plot), name = svg.substr(0, svg.find(">steep<"));
    INFO(svg);
    const std::string place = name.substr(name.rfind("<text"));
    const double x = std::stod(place.substr(place.find("x=\"") + 3)),
                 y = std::stod(place.substr(place.find("y=\"") + 3));
    CHECK(x > 58);
    CHECK(x < 372);
    for (double at = x; at < x + 26; at += 1) {
        const double curve = 34 + (at - 58) / (314 * std::log10(47) / 2) * 250;
        INFO(at);
        CHECK((curve < y - 9 || curve > y + 1));
    }
}
