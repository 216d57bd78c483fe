#include "diagnosis/divergence.h"

#include "catch.h"

using Catch::Matchers::ContainsSubstring;
using grade::first_divergence;

TEST_CASE("paths part at the first line that differs, which is shown with the sample's lines before it",
          "[divergence]") {
    const std::string right =
        "pixel 3,4: 2 samples\n"
        "sample 0\n  camera_ray          along (0, 0, -1)\n  gathered            (1, 1, 1)\n"
        "sample 1\n  camera_ray          along (0, 0.5, -1)\n  light_sample        density 2 / sr\n"
        "  gathered            (3, 3, 3)\n";
    std::string mine = right;
    mine.replace(mine.find("density 2"), 9, "density 4");
    mine.replace(mine.find("(3, 3, 3)"), 9, "(1.5, 1.5, 1.5)");
    CHECK(first_divergence(mine, right) ==
          "sample 1\n  camera_ray          along (0, 0.5, -1)\n"
          "yours:\n  light_sample        density 4 / sr\n"
          "the solution's:\n  light_sample        density 2 / sr\n");
    CHECK(first_divergence(right, right).empty());
}

TEST_CASE("numbers that differ in the last digits that are shown are the same", "[divergence]") {
    const auto parts = [](const std::string& a, const std::string& b) {
        return !first_divergence("sample 0\nx " + a + "\n", "sample 0\nx " + b + "\n").empty();
    };
    CHECK(!parts("0.123456", "0.123457"));
    CHECK(!parts("(1, 2.00001e-12)", "(1, -3e-17)"));
    CHECK(!parts("inf", "inf"));
    CHECK(!parts("nan", "nan"));
    CHECK(parts("0.1234", "0.1236"));
    CHECK(parts("-1", "1"));
    CHECK(parts("inf", "1"));
    CHECK(parts("nan", "1"));
    CHECK(parts("shape 1", "shape 2"));
    CHECK(parts("arrives", "stopped by shape 1"));
}

TEST_CASE("what a program tells of its paths is shown as text of one line", "[divergence]") {
    const std::string shown =
        first_divergence("sample 0\nx \x1b[31m" + std::string(5000, 'a') + "\n", "sample 0\nx 1\n");
    CHECK(shown.find('\x1b') == shown.npos);
    CHECK(shown.size() < 500);
    CHECK_THAT(shown, ContainsSubstring("yours:\nx ?[31maaa"));
}
