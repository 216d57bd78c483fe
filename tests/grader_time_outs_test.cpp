#include "catch.h"
#include "diagnosis/diagnosis.h"
#include "graded.h"
#include "judging/budget.h"

using namespace grade;
using namespace grade::small;

namespace {

/// Calls of mirror_direction with these d.x, a row each.
Check mirror_check(const std::string& name, std::vector<double> xs) {
    Check check = toy_checks().front();
    check.name = name;
    check.experiment = Probe{"mirror_direction", [xs](Generator&) {
                                 Rows rows;
                                 for (const double x : xs) rows.push_back(row(rt::vec3(x, 0, 0), rt::vec3(0, 0, 1)));
                                 return rows;
                             }};
    return check;
}

FragmentRecord graded_with(const std::string& text, std::vector<Check> checks, int jobs) {
    GradingSettings settings;
    settings.only = {"mirror_direction"};
    settings.time_limit = 1;
    settings.build.jobs = jobs;
    settings.build.trusted = true;
    const Record record = grade_submission(submission({{"mirror_direction", text}}), read_assignment("assignment.toml"),
                                           toolchain(), ready(std::move(checks)), settings);
    return of(record, "mirror_direction");
}

}  // namespace

TEST_CASE("of a loop that does not end its line is told, and the first call that it does not answer") {
    const std::string text = mirror("while (d.x > 2) {\n    d.y += 1;\n}\n" + right);
    const FragmentRecord fragment = graded_with(text, {mirror_check("one", {1, 2, 3, 4})}, 1);
    CHECK(fragment.verdict == Verdict::timed_out);
    CHECK(fragment.checks[0].trouble == Trouble::endless);
    INFO(first_message(fragment));
#ifndef __SANITIZE_ADDRESS__
    CHECK(fragment.finding.fault == "mirror_direction.cpp:6: the loop here does not end");
    CHECK(fragment.finding.command == "./grade call mirror_direction 'd = (3, 0, 0), n = (0, 0, 1)'");
    CHECK_THAT(first_message(fragment), Catch::Matchers::ContainsSubstring("\nFor d = (3, 0, 0)"));
#endif
}

TEST_CASE("checks before one that does not end count, whichever processor was faster") {
    const std::string text =
        mirror("if (d.x == 1) usleep(1'200'000);\nwhile (d.x > 2) d.y += 1;\n" + right, "#include <unistd.h>\n");
    const auto verdicts = [&](int jobs) {
        std::vector<Verdict> all;
        const FragmentRecord fragment =
            graded_with(text,
                        {mirror_check("a", {1}), mirror_check("b", {0}), mirror_check("c", {2}), mirror_check("d", {3}),
                         mirror_check("e", {0})},
                        jobs);
        for (const CheckRecord& check : fragment.checks) all.push_back(check.verdict);
        return all;
    };
    using enum Verdict;
    const std::vector<Verdict> expected{passed, passed, passed, timed_out, timed_out};
    CHECK(verdicts(1) == expected);
    CHECK(verdicts(2) == expected);
}

TEST_CASE("a fragment's budget is a time for whatever it does, and many times what the solution needs") {
    double mine = 0, other = 0;
    int asked = 0;
    const auto needs = [&](double seconds) { return [&asked, seconds] { return ++asked, seconds; }; };
    Budget budget;
    CHECK(budget.covers(mine, 4, needs(0)));
    CHECK(budget.covers(other, 4.9, needs(0)));
    CHECK(asked == 0);                                              // where it cannot matter, the solution does not run
    CHECK(budget.covers(mine, 1000, needs(1000 / Budget::times)));  // as the solution, on a machine that is much slower
    CHECK(budget.covers(other, 29, needs(0.01)));
    CHECK_FALSE(budget.covers(mine, 1010, needs(1000 / Budget::times)));
}
