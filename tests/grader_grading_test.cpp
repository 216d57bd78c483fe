
#include "catch.h"
#include "checks/kit/probe_check.h"
#include "diagnosis/diagnosis.h"
#include "files/files.h"
#include "judging/budget.h"
#include "judging/grading.h"
#include "protocol/rows.h"
#include "report/json.h"

using namespace grade;

namespace {

/// A check of one statistic, of calls with random arguments.
Check toy(const std::string& fragment, std::function<Rows(Generator&)> inputs, Statistic statistic) {
    return {"toy", fragment, Probe{fragment, std::move(inputs)}, {std::move(statistic)}};
}

/// A few small checks: one without noise, one with, one that is like the solution.
std::vector<Check> toy_checks() {
    const auto change_of_length = [](const Observation& seen) {
        double most = 0;
        for (std::size_t i = 0; i < seen.inputs.size(); ++i) {
            const auto d = from_row<rt::vec3>(seen.inputs[i]), r = from_row<rt::vec3>(seen.outputs[i]);
            most = std::max(most, std::abs(glm::length(d) - glm::length(r)));
        }
        return most;
    };
    const auto squared_radius = [](const Observation& seen) {
        double sum = 0;
        for (const Row& out : seen.outputs) {
            const auto sample = from_row<rt::DiskSample>(out);
            sum += rt::dot(sample.point, sample.point);
        }
        return sum / double(seen.outputs.size());
    };
    const auto directions = [](const Observation& seen) {
        rt::vec3 total(0);
        for (const Row& out : seen.outputs) total += rt::unit(from_row<rt::Ray>(out).direction);
        return total.x + 2 * total.y + 3 * total.z;
    };
    const auto keep = [](double, double) { return std::string("keep the length"); };
    return {toy("mirror_direction",
                rows_of(20,
                        [](Generator& random) {
                            const rt::vec3 d = box(random, -2, 2);
                            return row(d, direction(random));
                        }),
                {"M", "largest change of length [1]", change_of_length, 0.0, 0, 1e-12, true, keep}),
            toy("uniform_disk", rows_of(200, [](Generator& random) { return row(square(random)); }),
                {"D2", "mean squared radius [1]", squared_radius, 0.5, 0.002, 0.05, false, {}}),
            toy("camera_ray", rows_of(10, [](Generator& random) { return row(rt::Camera{}, 256.0 * square(random)); }),
                {"C", "sum of directions [1]", directions, std::nullopt, 0, 1e-9, true, {}})};
}

const std::vector<std::string> names{"mirror_direction", "uniform_disk", "camera_ray"};

const Toolchain& toolchain() {
    static const Toolchain chain = read_toolchain(GRADE_TOOLCHAIN);
    return chain;
}

std::string solution(const std::string& fragment) { return read_text("solution/" + fragment + ".cpp").value(); }

/// The solution of the three, with other texts for some.
Submission submission(const std::map<std::string, std::string>& changed) {
    Submission result{.name = "test"};
    for (const std::string& name : names)
        result.texts[name] = changed.contains(name) ? changed.at(name) : solution(name);
    return result;
}

Record graded(const Submission& submission) {
    GradingSettings settings;
    settings.only = {names.begin(), names.end()};
    settings.seed = 7;
    settings.build.jobs = 2;
    settings.time_limit = 1;
    return grade_submission(submission, read_assignment("assignment.toml"), toolchain(), ready(toy_checks()), settings);
}

const FragmentRecord& of(const Record& record, const std::string& name) {
    return *std::ranges::find(record.fragments, name, &FragmentRecord::name);
}

/// A text of mirror_direction with this body, and this before it.
std::string mirror(const std::string& body, const std::string& before = "") {
    return "#include \"rt/fragments.h\"\n#include <cstdlib>\n#include <cstdio>\n" + before +
           "namespace rt {\nvec3 mirror_direction(vec3 d, vec3 n) {\n" + body + "\n}\n}\n";
}

const std::string right = "return d - 2.0 * dot(d, n) * n;";

/// Grades a mirror_direction; the two others must not suffer.
FragmentRecord graded_mirror(const std::string& text) {
    const Record record = graded(submission({{"mirror_direction", text}}));
    CHECK(of(record, "uniform_disk").verdict == Verdict::passed);
    CHECK(of(record, "camera_ray").verdict == Verdict::passed);
    return of(record, "mirror_direction");
}

/// What a mirror_direction does, and what its author reads.
struct Mistake {
    const char* what;
    std::string text;
    Verdict verdict;
    const char* words;
};

const Mistake mistakes[] = {
    {"is blank", mirror("// nothing yet\nreturn not_started(d);"), Verdict::not_started, ""},
    {"has another signature",
     "#include \"rt/fragments.h\"\nnamespace rt { vec3 mirror_direction(const vec3& d, vec3 n) { return d + n; } }\n",
     Verdict::did_not_build, "signature differs from fragments.h"},
    {"calls what is nowhere defined", mirror("return helper(d);", "namespace rt { vec3 helper(vec3); }\n"),
     Verdict::did_not_build, "helper"},
    {"crashes", mirror("volatile int* p = nullptr; return d * double(*p);"), Verdict::crashed,
#ifdef __SANITIZE_ADDRESS__  // which has a handler of its own
     ""},
#else
     "SIGSEGV"},
#endif
    {"leaves the program, whatever it printed", mirror("std::puts(\"PASS 100\"); std::_Exit(0);"), Verdict::crashed,
     "must return"},
    {"throws", mirror("throw std::runtime_error(\"oh no\");", "#include <stdexcept>\n"), Verdict::crashed, "oh no"},
    {"never ends", mirror("volatile bool on = true; while (on) {} return d;"), Verdict::timed_out,
     "ran longer than 1 s; the solution needs"},
    {"sleeps for ever", mirror("sleep(1000); return d;", "#include <unistd.h>\n"), Verdict::timed_out,
     "waits for something: no answer came within 5 s; the solution needs"},
    {"takes all memory",
     mirror("static std::vector<char> all; all.resize(3ull << 30, 1); return d;", "#include <vector>\n"),
     Verdict::crashed, "uses more than 2 GB of memory"},
    {"forks", mirror("while (true) fork(); return d;", "#include <unistd.h>\n"), Verdict::crashed,
     "starts other programs"},
    {"starts a shell", mirror("(void)!std::system(\"true\"); return d;"), Verdict::crashed, "starts other programs"},
    {"forks with vfork", mirror("vfork(); return d;", "#include <unistd.h>\n"), Verdict::crashed,
     "starts other programs"},
    {"returns NaN", mirror("return d * std::sqrt(-1.0 - dot(d, d));", "#include <cmath>\n"), Verdict::not_finite,
     "mirror_direction returned nan: look for 0/0"},
    {"keeps state", mirror("static double k = 1; k *= 1.5; return k * d;"), Verdict::failed,
     "again with the same arguments"}};

}  // namespace

TEST_CASE("the solution's fragments get all points, whatever helpers they define") {
    const Record record = graded(
        submission({{"mirror_direction",
                     mirror(right,
                            "#include <cmath>\nint helper = 1;\nvoid* operator new(std::size_t) { std::abort(); }\n"
                            "extern \"C\" int fcntl(int, int, ...) { return -1; }\n")}}));
    for (const FragmentRecord& fragment : record.fragments) {
        INFO(fragment.name << ": " << name(fragment.verdict) << ": " << first_message(fragment));
        CHECK(fragment.verdict == Verdict::passed);
        CHECK(fragment.points == fragment.max_points);
    }
}

TEST_CASE("a fragment without a check is the instructor's error, and no verdict") {
    GradingSettings settings;
    settings.only = {"phong"};
    settings.time_limit = 1;
    Submission one{.name = "test"};
    one.texts["phong"] = solution("phong");
    CHECK_THROWS_WITH(
        grade_submission(one, read_assignment("assignment.toml"), toolchain(), ready(toy_checks()), settings),
        Catch::Matchers::ContainsSubstring("assignment.toml lists phong, and this grader has no check of it"));
}

TEST_CASE("what goes wrong in a fragment is told, and costs only itself") {
    for (const Mistake& mistake : mistakes) {
        const FragmentRecord fragment = graded_mirror(mistake.text);
        INFO("a mirror_direction that " << mistake.what << ": " << name(fragment.verdict) << ": "
                                        << first_message(fragment));
        CHECK(fragment.verdict == mistake.verdict);
        CHECK(fragment.points == 0);
        CHECK(first_message(fragment).find(mistake.words) != std::string::npos);
    }
}

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

TEST_CASE("a fragment that does not compile shows the first error with file and line") {
    const FragmentRecord fragment = graded_mirror(mirror("return d - 2.0 * dot(d, normal) * n;"));
    CHECK(fragment.verdict == Verdict::did_not_build);
    INFO(fragment.message);
    CHECK(fragment.message.starts_with("mirror_direction.cpp:6:"));
    CHECK(fragment.message.find("normal") != std::string::npos);
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

TEST_CASE("a fragment that divides by 0 does not pass, be it inf or nan") {
    const FragmentRecord fragment = graded_mirror(mirror("return d / (dot(d, n) - dot(n, d));"));
    INFO(first_message(fragment));
    CHECK(fragment.verdict != Verdict::passed);
}

TEST_CASE("a fragment that keeps what its first call was given is told so, and no formula") {
    const FragmentRecord fragment =
        graded_mirror(mirror("static const Real first = dot(d, n);\nreturn d - 2 * first * n;"));
    CHECK(fragment.verdict == Verdict::failed);
    CHECK(first_message(fragment).starts_with("the answer to a call hangs on the calls before it"));
    CHECK(fragment.finding.code.empty());
}

TEST_CASE("a wrong fragment fails with the hint of its statistic") {
    const FragmentRecord fragment = graded_mirror(mirror("return d - dot(d, n) * n;"));
    CHECK(fragment.verdict == Verdict::failed);
    CHECK(
        first_message(fragment).starts_with("the fragment answers exactly as if it had `along` "
                                            "in place of `2 * along` everywhere: see line 6\n"));
    CHECK_THAT(first_message(fragment), Catch::Matchers::ContainsSubstring("\nFor d = "));
    CHECK(fragment.points == 0);

    const Record disk =
        graded(submission({{"uniform_disk",
                            "#include \"rt/fragments.h\"\nnamespace rt { DiskSample uniform_disk(vec2 u) {\n"
                            "return {u.x * vec2(std::cos(2 * pi * u.y), std::sin(2 * pi * u.y)), 1 / pi}; } }\n"}}));
    CHECK(of(disk, "uniform_disk").verdict == Verdict::failed);
    CHECK(of(disk, "mirror_direction").verdict == Verdict::passed);
}

TEST_CASE("the same submission and seed give the same record but for times") {
    const Submission same = submission({{"mirror_direction", mirror("return d;")}});
    CHECK(timeless_json(graded(same)) == timeless_json(graded(same)));
}

TEST_CASE("only checks whose fragment has changed run again, and come out as they would alone") {
    const TemporaryFolder folder;
    const auto again = [&](const Submission& what, bool keep) {
        GradingSettings settings;
        settings.only = {names.begin(), names.end()};
        settings.build.jobs = 2;
        if (keep) settings.build.kept = Kept(folder.path(), toolchain());
        return grade_submission(what, read_assignment("assignment.toml"), toolchain(), ready(toy_checks()), settings);
    };
    const auto verdicts = [](const Record& record) {
        std::vector<Verdict> all;
        for (const FragmentRecord& fragment : record.fragments) all.push_back(fragment.verdict);
        return all;
    };
    const Submission good = submission({});
    CHECK(again(good, true).reused == 0);
    const Record second = again(good, true);
    CHECK(second.reused == 3);
    CHECK(verdicts(second) == verdicts(again(good, false)));
    CHECK(second.fragments[0].checks[0].statistics.size() == 1);

    CHECK(again(submission({{"camera_ray", solution("camera_ray") + "\n"}}), true).reused == 2);
    const Submission wrong = submission({{"mirror_direction", mirror("return 2.0 * d;")}});
    const Record third = again(wrong, true);
    CHECK(of(third, "mirror_direction").verdict == Verdict::failed);
    CHECK(third.reused == 1);  // what is kept of camera_ray is of its edited text
    CHECK(verdicts(third) == verdicts(again(wrong, false)));
    CHECK(again(wrong, true).reused == 3);
}
