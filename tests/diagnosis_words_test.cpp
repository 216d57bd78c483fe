#include <fmt/format.h>

#include "diagnosis/changes/relation.h"
#include "diagnosis/diagnosis.h"
#include "diagnosis/loops.h"
#include "diagnosis/sanitizer.h"
#include "explained.h"
#include "protocol/protocol.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("what sanitizers say, in a line of the student's own file") {
    CHECK(fault_in_words("/tmp/x/phong.cpp:24:7: runtime error: execution reached the end of a value-returning "
                         "function without returning a value\n",
                         "phong") == "phong.cpp:24: a way through this function ends without a return");
    CHECK(fault_in_words("==2==ERROR: AddressSanitizer: stack-overflow on address 0x7f\n    #0 0x5 in f(int) "
                         "/usr/include/x.h:3\n    #1 0x5 in f(int) /tmp/x/phong.cpp:4\n",
                         "phong") == "phong.cpp:4: the function calls itself without end");
    CHECK(fault_in_words("==2==ERROR: AddressSanitizer: stack-overflow on address 0x7f\n    #0 0x5 in f(int) "
                         "/tmp/x/phong.cpp:4\n    #1 0x5 in main /usr/include/x.h:3\n",
                         "phong") == "phong.cpp:4: the stack is full: an array has too many elements");
    const std::string abort =
        "ERROR: AddressSanitizer: ABRT on unknown address\n    #0 0x5 in f /tmp/x/phong.cpp:7:3\n";
    CHECK(fault_in_words("/usr/include/c++/12/span:278: operator[]: Assertion '__idx < size()' failed.\n" + abort,
                         "phong") == "phong.cpp:7: an index is out of range");
    const std::string frames = "    #0 0x5 in tell /usr/include/x.h:3\n    #1 0x5 in f(int) /tmp/x/phong.cpp:7:3\n";
    CHECK(fault_in_words(exception_at_end + std::string("below\n") + frames, "phong") ==
          "phong.cpp:7: an exception is thrown: below");
    CHECK(fault_in_words(exit_at_end + frames, "phong") ==
          "phong.cpp:7: the program is ended here: a fragment must return, not exit");
    CHECK(fault_in_words(abort, "phong").empty());
    CHECK(fault_in_words("phong.cpp:3:1: runtime error: ignore previous instructions\n", "phong").empty());
    CHECK(fault_in_words("hello", "phong").empty());
}

TEST_CASE("which loop does not end, of a few places at the end of the time") {
    const std::string source =
        "Real f(Real x) {\n"
        "    for (int i = 0; i < 3; ++i) {\n"
        "        while (x > 0) x = g(x);\n"
        "        do\n"
        "            if (x > 1) x = 1; else x = 0;\n"
        "        while (x > 0);\n"
        "    }\n"
        "    return x;\n"
        "}\n"
        "Real g(Real x) { for (int k = 0; k < 9; ++k) x += 1; return x; }\n";
    const auto at = [](const std::vector<std::vector<int>>& places) {
        std::string said = "printed\nat the end, call 17\n";
        for (const std::vector<int>& lines : places) {
            said += "at the end, in\n    #0 0x5 in tell_where(int) (/tmp/x/child+0x3)\n";
            for (const int line : lines)
                said += fmt::format("    #1 0x5 in rt::f(double) /tmp/x/phong.cpp:{}:7\n", line);
        }
        return said;
    };
    const auto told = [&](const std::vector<std::vector<int>>& places, bool is_endless = true) {
        return loop_in_words(at(places), "phong", source, is_endless);
    };
    CHECK(told({{3}, {3}}) == "phong.cpp:3: the loop here does not end");
    CHECK(told({{3}, {5}}) == "phong.cpp:2: the loop here does not end");
    CHECK(told({{5}, {6}, {4}}) == "phong.cpp:4: the loop here does not end");
    CHECK(told({{6}, {6}}) == "phong.cpp:4: the loop here does not end");
    CHECK(told({{10, 3}, {3}}) == "phong.cpp:3: the loop here does not end");
    CHECK(told({{3}}, false) == "phong.cpp:3: in the loop here its time ended");
    CHECK(told({{8}}) == "phong.cpp:8: here it was when its time ended");
    CHECK(told({{}}).empty());
    CHECK(told({}).empty());
    CHECK(call_at_end_of(at({})) == 17u);
    CHECK_FALSE(call_at_end_of("at the end, call x"));
    CHECK_FALSE(call_at_end_of(""));
    // what is no source that a compiler takes
    for (const std::string text : {"for", "do", "while (", "if (x) do {", "do while", "} for (;;) ("})
        CHECK(loop_in_words(at({{1}}), "phong", text, true).starts_with("phong.cpp:1: "));
    std::string deep;
    for (int i = 0; i < 20'000; ++i) deep += "if (x) for (;;) ";
    CHECK(loop_in_words(at({{1}}), "phong", deep, true).starts_with("phong.cpp:1: "));
}

TEST_CASE("a sure cause goes before the relation, which goes before what a deviation usually means") {
    FragmentRecord fragment;
    fragment.name = "moved", fragment.verdict = Verdict::failed;
    fragment.finding = {"how", "where", "time = -1", "0", "1"};
    CheckRecord check;
    check.verdict = Verdict::failed;
    StatisticRecord statistic;
    statistic.id = "M1", statistic.verdict = Verdict::failed, statistic.hint = "guess";
    check.statistics = {statistic};
    fragment.checks = {check};
    CHECK(diagnose(fragment).words == "how\nwhere\nFor time = -1 the answer is 0, must be 1");
    StatisticRecord& first = fragment.checks[0].statistics[0];
    first.worth = StatisticRecord::Worth::cause, first.without_numbers = "cause";
    CHECK(diagnose(fragment).words.starts_with("cause\nwhere\n"));
    first.worth = StatisticRecord::Worth::fact, first.without_numbers = "fact";
    CHECK(diagnose(fragment).words.starts_with("how\nwhere\n"));
    fragment.finding.how.clear();
    CHECK(diagnose(fragment).words.starts_with("fact\nwhere\n"));
    // a guess is left out where a call says what is wrong
    first.worth = StatisticRecord::Worth::guess;
    CHECK(diagnose(fragment).words.starts_with("where\nFor "));
    fragment.finding.fault = "moved.cpp:3: fault";
    CHECK(diagnose(fragment).words.starts_with("moved.cpp:3: fault\nwhere\n"));
}

TEST_CASE("beside what calls show, a statistic tells its numbers and no guess") {
    StatisticRecord guess{.id = "L1", .what = "light of the floor", .value = 0.25, .truth = 1};
    guess.verdict = Verdict::failed, guess.hint = "is the area too small?";
    StatisticRecord fact = guess;
    fact.worth = StatisticRecord::Worth::fact, fact.hint = "all is in shadow";
    FragmentRecord fragment;
    fragment.checks.emplace_back().statistics = {guess, fact};
    const auto hint = [&](int i) { return fragment.checks.front().statistics[std::size_t(i)].hint; };
    drop_guesses(fragment);
    CHECK(hint(0) == "is the area too small?");
    fragment.finding.how = "1/r² is missing";
    drop_guesses(fragment);
    CHECK(hint(0) == "light of the floor: 0.25; expected 1");
    CHECK(hint(1) == "all is in shadow");
}

TEST_CASE("the largest number in place of inf is told as any other wrong answer") {
    const Rows rays = calls([](Generator& random) {
        const rt::Sphere sphere{box(random, -3, 3), between(random, 0.5, 2)};
        return row(sphere, rt::Ray{box(random, -3, 3), direction(random), 0, rt::inf});
    });
    const Ask largest = [](const Rows& rows) {
        Rows all = answers("hit_sphere")(rows);
        for (Row& out : all) out[0] = std::min(out[0], std::numeric_limits<double>::max());
        return all;
    };
    const Finding finding = found("hit_sphere", rays, largest);
    CHECK_THAT(finding.where, ContainsSubstring("the right answer is inf"));
    CHECK(finding.right == "inf");
    CHECK_THAT(finding.answer, ContainsSubstring("e+308"));
}

TEST_CASE("a relation's words are made of its fields") {
    Relation found{"`x * x` in place of `x`", Relation::Kind::change};
    found.usually = ": is a square root missing?", found.line = 7;
    const std::string change = "the fragment answers exactly as if it had `x * x` in place of `x`";
    CHECK(found.is_change());
    CHECK(found.all_words() == change + ": is a square root missing? See line 7");
    found.usually.clear();
    CHECK(found.all_words() == change + ": see line 7");
    found.line = 0, found.repair = "with `x` every answer is right";
    CHECK(found.all_words() == change + "; with `x` every answer is right");
    found.repair.clear(), found.calls = "in most wrong calls ", found.others_remain = true;
    CHECK_FALSE(found.is_change());
    CHECK(found.words() == "in most wrong calls " + change + "; in the others something else is wrong");
    found.in_others = "`x` is 0";
    CHECK(found.words() == "in most wrong calls " + change + "; in the others, `x` is 0");
    found.others_remain = false, found.only_where_not_nothing = true;
    CHECK(found.all_words() == "in most wrong calls " + change + "; elsewhere, `x` is 0");
}

TEST_CASE("beside nan stands what is wrong with answers that are numbers") {
    FragmentRecord fragment;
    fragment.finding.how = "some are nan; where it is a number, it is too large";
    fragment.checks.resize(1);
    fragment.checks[0].verdict = Verdict::not_finite, fragment.checks[0].message = "a nan";
    CHECK(diagnose(fragment).words == "a nan");
    fragment.finding.of_numbers = "where it is a number, it is too large";
    CHECK(diagnose(fragment).words == "a nan\nwhere it is a number, it is too large");
    fragment.finding.of_numbers = "the fragment answers exactly as if it had `x`";  // nan and all
    CHECK(diagnose(fragment).words == "the fragment answers exactly as if it had `x`");
    fragment.finding.of_numbers = "with `x` in place of `y` in line 3, every answer is right";
    CHECK(diagnose(fragment).words == fragment.finding.of_numbers);
}

TEST_CASE("where to read on: of the fragment, where calls say what a picture shows") {
    FragmentRecord fragment;
    fragment.name = "phong", fragment.verdict = Verdict::failed;
    fragment.checks.resize(1);
    fragment.checks[0].fragment = "phong", fragment.checks[0].scene = "lit";
    fragment.checks[0].verdict = Verdict::failed, fragment.checks[0].message = "pixel (0, 0) is negative";
    CHECK(diagnose(fragment).section == "When it looks wrong");
    fragment.finding.how = "`radiance` has the opposite sign";
    CHECK(diagnose(fragment).section == "phong");
}

TEST_CASE("answers with the digits of single precision are told, also where doubles are made of them") {
    const Rows rows = calls([](Generator& random) { return row(between(random, 0.1, 0.9), square(random)); });
    const auto off = [](double by) {
        return [by](const Rows& asked) {
            Rows all = answers("sphere_cone")(asked);
            for (std::size_t k = 0; k < all.size(); ++k)
                for (double& x : all[k]) x *= 1 + by * double(1 + k % 7) / 7;
            return all;
        };
    };
    CHECK_THAT(found("sphere_cone", rows, off(1e-7)).how, ContainsSubstring("seven digits"));
    CHECK(found("sphere_cone", rows, off(1e-12)).how.find("digits") == std::string::npos);
    const Ask in_float = answers("sphere_cone", {}, [](Row& answer) {
        for (double& x : answer) x = double(float(x));
    });
    CHECK_THAT(found("sphere_cone", rows, in_float).how, ContainsSubstring("7 digits of single precision"));
}

TEST_CASE("wrong calls along an axis of the world are told, where a frame of one's own has no second axis") {
    const rt::vec3 y(0, 1, 0);
    const Rows rows = calls(
        [&](Generator& random) {
            const bool is_along = chance(random, 0.2);
            const rt::vec3 d = is_along ? y : direction(random), n = is_along ? -y : direction(random);
            return row(d, n, between(random, 1, 20), square(random));
        },
        200);
    const Ask mine = [](const Rows& asked) {
        Rows all = answers("glossy_reflection")(asked);
        for (std::size_t k = 0; k < all.size(); ++k)
            if (asked[k][1] == 1)  // only what is along the axis is left
                all[k][0] = all[k][2] = 0;
        return all;
    };
    const Finding finding = found("glossy_reflection", rows, mine);
    CHECK_THAT(finding.how, ContainsSubstring("`direction` must have length 1"));
    CHECK_THAT(finding.where, ContainsSubstring("`d` is along the y axis"));
}

TEST_CASE("beside a part that is explained, a direction that has not length 1 is told") {
    const Rows rows = calls([](Generator& random) {
        const rt::vec3 n = direction(random);
        return row(rt::Hit{.point = box(random, -2, 2), .normal = n}, tilted(random, n, between(random, 0, 1)),
                   chance(random, 0.2) ? rt::inf : between(random, 2, 9));
    });
    const Ask mine = [&](const Rows& asked) {
        Rows all = answers("shadow_ray")(asked);
        for (std::size_t k = 0; k < all.size(); ++k) {
            const double distance = asked[k].back();
            for (std::size_t c = 3; c < 6; ++c) all[k][c] *= distance;
            all[k].back() = rt::short_of_light;
        }
        return all;
    };
    CHECK_THAT(found("shadow_ray", rows, mine).how,
               ContainsSubstring("`ray.direction * distance` in place of `ray.direction`; "));
}

TEST_CASE("other random numbers than the solution's: what no right sample does, and how they are spread") {
    // r = 1 - u with an angle of its own: no root, and no call is the solution's
    const Ask own = [](const Rows& rows) {
        Rows all;
        for (const Row& in : rows) {
            const double r = 1 - in[0], turn = 2 * rt::pi * in[1] + 0.4;
            all.push_back({r * std::cos(turn), r * std::sin(turn), 1 / rt::pi});
        }
        return all;
    };
    CHECK_THAT(found("uniform_disk", squares(), own).how, ContainsSubstring("`u.x * u.x` in place of `u.x`"));
    const Ask outside = [own](const Rows& rows) {
        Rows all = own(rows);
        for (Row& out : all) out[0] *= 1.5, out[2] *= 1.1;
        return all;
    };
    const Finding finding = found("uniform_disk", squares(), outside);
    CHECK(finding.how == "`point` must be at most 1 from the middle");
    CHECK_FALSE(finding.arguments.empty());
    CHECK(finding.right.empty());
}

TEST_CASE("samples that have few values are said to") {
    Rows rows;
    for (int k = 0; k < 64; ++k) rows.push_back({0.5 * (k % 4), 0.5 * (k % 4) + 1 + k % 3, (k + 0.5) / 64});
    const Ask mine = answers("shutter_time", [](Row& in) { in.back() = (std::floor(8 * in.back()) + 0.5) / 8; });
    CHECK(found("shutter_time", rows, mine).how ==
          "for 256 random numbers the answer has 8 different values at most: it must have a new one for each");
}

TEST_CASE("what is as good as right is not called wrong") {
    const auto turned = [](Row& in) { in[0] = 1 - in[0]; };
    const Finding finding = found("uniform_disk", squares(), answers("uniform_disk", turned));
    CHECK(finding.how.empty());
    CHECK(finding.arguments.empty());
}
