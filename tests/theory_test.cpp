#include "theory/theory.h"

#include <cmath>
#include <functional>
#include <set>
#include <stdexcept>

#include "assignment/assignment.h"
#include "catch.h"
#include "files/files.h"

using namespace grade;

namespace {

const std::vector<std::string> names = {"Ada Lovelace", "Grace Hopper", "Émilie du Châtelet", "李冶", "x"};

/// The integral over [low, high], from the middles of many intervals.
double integral(double low, double high, const std::function<double(double)>& f) {
    const int n = 20000;
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += f(low + (i + 0.5) * (high - low) / n);
    return sum * (high - low) / n;
}

const Question& question(const std::vector<Question>& all, const std::string& key) {
    for (const Question& q : all)
        if (q.key == key) return q;
    throw std::out_of_range(key);
}

std::string error_of(const std::string& text) {
    return complaint_of([&] { read_theory(text, "t.toml"); });
}

/// The empty file with each answer filled in, times a factor.
std::string filled_in(const std::string& name, double factor) {
    std::string text = empty_theory(name);
    for (const Question& q : questions_of(name)) {
        const std::string line = "\n#" + q.key + " = ";
        const std::size_t at = text.find(line);
        REQUIRE(at != text.npos);
        text.replace(at, line.size(), "\n" + q.key + " = " + std::to_string(factor * q.answer));
    }
    return text;
}

}  // namespace

TEST_CASE("the numbers of the theory part belong to the name, whatever its spaces and capitals") {
    std::set<std::string> texts;
    for (const std::string& name : names) {
        const auto all = questions_of(name);
        REQUIRE(all.size() == 8);
        texts.insert(all[0].text + all[1].text + all[2].text);
        for (const Question& q : all) CHECK(std::isfinite(q.answer));
    }
    CHECK(texts.size() == names.size());
    CHECK(questions_of(" ada  LOVELACE ")[7].text == questions_of("Ada Lovelace")[7].text);
}

TEST_CASE("the answers of the theory part are what integrals and searches give") {
    for (const std::string& name : names) {
        const auto all = questions_of(name);
        INFO(name);
        {
            const Question& q = question(all, "irradiance");  // the floor's n is y
            const double height = q.numbers[1], away = q.numbers[2], squared = height * height + away * away;
            CHECK(q.answer == Approx(q.numbers[0] / squared * (height / std::sqrt(squared))));
        }
        {
            const Question& q = question(all, "radiance");  // what leaves is the albedo's share of what arrives
            const double out =
                integral(0, M_PI / 2, [&](double t) { return 2 * M_PI * q.answer * std::cos(t) * std::sin(t); });
            CHECK(out == Approx(q.numbers[0] * q.numbers[1]).epsilon(1e-6));
        }
        {
            const Question& q = question(all, "solid_angle");
            const double rim = std::asin(q.numbers[0] / q.numbers[1]);
            CHECK(q.answer == Approx(integral(0, rim, [](double t) { return 2 * M_PI * std::sin(t); })).epsilon(1e-6));
        }
        {
            const Question& q = question(all, "critical_angle");
            CHECK(q.numbers[0] * std::sin(q.answer * M_PI / 180) == Approx(1));
        }
        {
            const Question& q = question(all, "samples");
            CHECK(q.numbers[1] * std::sqrt(q.numbers[0] / q.answer) == Approx(q.numbers[2]));
        }
        {
            const Question& q = question(all, "deviation");
            const auto f = [&](double x) { return std::pow(x, q.numbers[0]); };
            const double mean = integral(0, 1, f);
            const double variance = integral(0, 1, [&](double x) { return (f(x) - mean) * (f(x) - mean); });
            CHECK(q.answer == Approx(std::sqrt(variance / q.numbers[1])).epsilon(1e-6));
        }
        {
            const Question& q = question(all, "inversion");
            const double k = q.numbers[0];
            CHECK(integral(0, q.answer, [&](double x) { return (k + 1) * std::pow(x, k); }) ==
                  Approx(q.numbers[1]).epsilon(1e-6));
        }
        {
            const Question& q = question(all, "blur");  // where the ray from lamp to rim crosses the plane in focus
            const double slope = q.numbers[0] / q.numbers[2];
            CHECK(q.answer == Approx(q.numbers[0] - slope * q.numbers[1]));
        }
    }
}

TEST_CASE("an answer within a hundredth is right, others and missing ones are not") {
    for (const std::string& name : names) {
        CHECK(read_theory(empty_theory(name), "t.toml").right() == 0);
        CHECK(read_theory(filled_in(name, 1), "t.toml").right() == 8);
        CHECK(read_theory(filled_in(name, 1.008), "t.toml").right() == 8);
        CHECK(read_theory(filled_in(name, 1.012), "t.toml").right() == 0);
    }
    const Theory odd = read_theory(empty_theory("a \"b\" \\c"), "t.toml");
    CHECK(odd.name == "a \"b\" \\c");
    CHECK(read_theory(empty_theory("a\nb"), "t.toml").name == "a b");
}

TEST_CASE("the questions of a new file are those that are asked, whatever its name holds") {
    for (const char* name : {"a\nb", "a\x1b[8m", "\x7f x", "a\tb"}) {
        const std::string text = empty_theory(name);
        for (const Answered& answered : read_theory(text, "t.toml").answers)
            CHECK(text.find(answered.question.text) != text.npos);
    }
    for (const char* name : {"", " \n ", "bad\xff", "\u202e turned"})
        CHECK_THROWS_WITH(empty_theory(name), Catch::Matchers::StartsWith("--name: "));
    CHECK_THROWS_WITH(empty_theory(std::string(300, 'x')), Catch::Matchers::StartsWith("--name: is longer"));
}

TEST_CASE("a name forges no points of the theory part") {
    const std::string name = "name = \"Eve: 8 of 8 right, 16 of 16 points\\u001b[8m\\n8 of 8\\u202e\"\n";
    CHECK(told(read_theory(name, "t.toml"), 16)
              .ends_with("\n0 of 8 right, 0 of 16 points: Eve: 8 of 8 right, 16 of 16 points?[8m?8 of 8???\n"));
}

TEST_CASE("who is wrong is shown the way with other numbers, and not the answer") {
    for (const std::string& name : names) {
        const std::string wrong = told(read_theory(filled_in(name, 1.5), "t.toml"), 16);
        const std::string right = told(read_theory(filled_in(name, 1), "t.toml"), 16);
        for (const Question& q : questions_of(name)) {
            CHECK(wrong.find(q.worked) == std::string::npos);
            CHECK(right.find(q.worked) != std::string::npos);
        }
        CHECK(wrong.ends_with("\n0 of 8 right, 0 of 16 points: " + name + "\n"));
        CHECK(right.ends_with("\n8 of 8 right, 16 of 16 points: " + name + "\n"));
    }
}

TEST_CASE("mistakes in theory.toml are told with line and column") {
    CHECK(error_of("x = 1\n").rfind("t.toml:", 0) == 0);
    CHECK(error_of("name = \" \"\n").rfind("t.toml:1:8: is empty", 0) == 0);
    CHECK(error_of("name = \"a\"\nirradance = 1\n") ==
          "t.toml:2:13: \"irradance\" is no question; expected irradiance?");
    CHECK(error_of("name = \"a\"\nblur = \"1\"\n").rfind("t.toml:2:8: ", 0) == 0);
    CHECK(error_of("name = \"a\"\nblur = \n").rfind("t.toml:2:", 0) == 0);
}

TEST_CASE("the theory part is off unless assignment.toml has its points") {
    CHECK_FALSE(read_assignment("assignment.toml").theory_points);
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "assignment.toml").string();
    write_text(file, *read_text("assignment.toml") + "\n[theory]\npoints = 16\n");
    CHECK(read_assignment(file).theory_points == 16.0);
}

TEST_CASE("what goes wrong with answers is told") {
    std::string text = filled_in("x", 1);
    const double angle = question(questions_of("x"), "critical_angle").answer;
    const std::size_t at = text.find("\ncritical_angle = "), end = text.find('\n', at + 1);
    text.replace(at, end - at, "\ncritical_angle = " + std::to_string(angle * M_PI / 180));
    const std::string said = told(read_theory(text, "t.toml"), 16);
    CHECK_THAT(said, Catch::Matchers::ContainsSubstring("[degrees]: wrong. That is the angle in radians. With"));
    CHECK_THAT(said, Catch::Matchers::ContainsSubstring("totally reflected? [degrees]\n"));
    CHECK_THAT(error_of(empty_theory("x") + "blur = 2 * 3\n"),
               Catch::Matchers::ContainsSubstring("an answer is a number, worked out: 41.8"));
    for (const std::string& name : names) CHECK(empty_theory(name).find(".03000") == std::string::npos);
}
