
#include "catch.h"
#include "diagnosis/diagnosis.h"
#include "files/files.h"
#include "judging/budget.h"
#include "judging/grading.h"
#include "protocol/rows.h"
#include "report/json.h"
#include "rt/files/scene_reader.h"

using namespace grade;

namespace {

/// A few small checks: one without noise, one with, one picture, one for a fragment that nobody spoils.
Check keeps_length() {
    Check mirror;
    mirror.name = "length";
    mirror.fragment = "mirror_direction";
    mirror.experiment = Probe{"mirror_direction", [](Generator& generator) {
                                  std::normal_distribution<double> normal;
                                  Rows rows;
                                  for (int i = 0; i < 20; ++i) {
                                      const rt::vec3 d(normal(generator), normal(generator), normal(generator));
                                      rows.push_back(row(d, rt::unit({normal(generator), normal(generator), 1})));
                                  }
                                  return rows;
                              }};
    Statistic length{"M",  "largest change of length [1]",
                     {},   0.0,
                     0,    1e-12,
                     true, [](double, double) { return std::string("keep the length"); }};
    length.measure = [](const Observation& seen) {
        double most = 0;
        for (std::size_t i = 0; i < seen.inputs.size(); ++i) {
            const auto d = from_row<rt::vec3>(seen.inputs[i]), r = from_row<rt::vec3>(seen.outputs[i]);
            most = std::max(most, std::abs(glm::length(d) - glm::length(r)));
        }
        return most;
    };
    mirror.statistics = {length};
    return mirror;
}

Check mean_radius() {
    Check disk;
    disk.name = "radius";
    disk.fragment = "uniform_disk";
    disk.experiment = Probe{"uniform_disk", [](Generator& generator) {
                                std::uniform_real_distribution<double> uniform;
                                Rows rows;
                                for (int i = 0; i < 200; ++i) {
                                    const double u = uniform(generator), v = uniform(generator);
                                    rows.push_back(row(rt::vec2(u, v)));
                                }
                                return rows;
                            }};
    Statistic radius{"D2", "mean squared radius [1]", {}, 0.5, 0.002, 0.05, false, {}};
    radius.measure = [](const Observation& seen) {
        double sum = 0;
        for (const Row& out : seen.outputs) {
            const auto sample = from_row<rt::DiskSample>(out);
            sum += rt::dot(sample.point, sample.point);
        }
        return sum / double(seen.outputs.size());
    };
    disk.statistics = {radius};
    return disk;
}

Check like_the_solution() {
    Check ray;
    ray.name = "like the solution";
    ray.fragment = "camera_ray";
    ray.experiment = Probe{"camera_ray", [](Generator& generator) {
                               std::uniform_real_distribution<double> uniform(0, 256);
                               Rows rows;
                               for (int i = 0; i < 10; ++i) {
                                   const double x = uniform(generator), y = uniform(generator);
                                   rows.push_back(row(rt::Camera{}, rt::vec2(x, y)));
                               }
                               return rows;
                           }};
    Statistic sum{"C", "sum of directions [1]", {}, std::nullopt, 0, 1e-9, true, {}};
    sum.measure = [](const Observation& seen) {
        rt::vec3 total(0);
        for (const Row& out : seen.outputs) total += rt::unit(from_row<rt::Ray>(out).direction);
        return total.x + 2 * total.y + 3 * total.z;
    };
    ray.statistics = {sum};
    return ray;
}

std::vector<Check> toy_checks() { return {keeps_length(), mean_radius(), like_the_solution()}; }

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

TEST_CASE("a blank is not started, and costs only itself") {
    const FragmentRecord fragment = graded_mirror(mirror("// nothing yet\nreturn not_started(d);"));
    CHECK(fragment.verdict == Verdict::not_started);
    CHECK(fragment.points == 0);
}

TEST_CASE("a fragment that does not compile shows the first error with file and line") {
    const FragmentRecord fragment = graded_mirror(mirror("return d - 2.0 * dot(d, normal) * n;"));
    CHECK(fragment.verdict == Verdict::did_not_build);
    INFO(fragment.message);
    CHECK(fragment.message.starts_with("mirror_direction.cpp:6:"));
    CHECK(fragment.message.find("normal") != std::string::npos);
}

TEST_CASE("a fragment with another signature is told what fragments.h declares") {
    const FragmentRecord fragment = graded_mirror(
        "#include \"rt/fragments.h\"\nnamespace rt { vec3 mirror_direction(const vec3& d, vec3 n) { return d + n; } "
        "}\n");
    CHECK(fragment.verdict == Verdict::did_not_build);
    INFO(fragment.message);
    CHECK(fragment.message.find("signature differs from fragments.h") != std::string::npos);
}

TEST_CASE("a fragment that calls what is nowhere defined did not build") {
    const FragmentRecord fragment = graded_mirror(mirror("return helper(d);", "namespace rt { vec3 helper(vec3); }\n"));
    CHECK(fragment.verdict == Verdict::did_not_build);
    INFO(fragment.message);
    CHECK(fragment.message.find("helper") != std::string::npos);
}

TEST_CASE("a fragment that crashes is told how") {
    const FragmentRecord fragment = graded_mirror(mirror("volatile int* p = nullptr; return d * double(*p);"));
    CHECK(fragment.verdict == Verdict::crashed);
    INFO(first_message(fragment));
#ifndef __SANITIZE_ADDRESS__  // which has a handler of its own
    CHECK(first_message(fragment).find("SIGSEGV") != std::string::npos);
#endif
}

TEST_CASE("a fragment that leaves the program is told so, whatever it printed") {
    const FragmentRecord fragment = graded_mirror(mirror("std::puts(\"PASS 100\"); std::_Exit(0);"));
    CHECK(fragment.verdict == Verdict::crashed);
    INFO(first_message(fragment));
    CHECK(first_message(fragment).find("must return") != std::string::npos);
}

TEST_CASE("a fragment that throws is told what") {
    const FragmentRecord fragment =
        graded_mirror(mirror("throw std::runtime_error(\"oh no\");", "#include <stdexcept>\n"));
    CHECK(fragment.verdict == Verdict::crashed);
    CHECK(first_message(fragment).find("oh no") != std::string::npos);
}

TEST_CASE("a fragment that never ends is stopped, with the time that the solution needs") {
    const FragmentRecord fragment = graded_mirror(mirror("volatile bool on = true; while (on) {} return d;"));
    CHECK(fragment.verdict == Verdict::timed_out);
    INFO(first_message(fragment));
    CHECK(first_message(fragment).find("ran longer than 1 s; the solution needs") != std::string::npos);
}

TEST_CASE("a fragment that sleeps for ever is stopped") {
    const FragmentRecord fragment = graded_mirror(mirror("sleep(1000); return d;", "#include <unistd.h>\n"));
    CHECK(fragment.verdict == Verdict::timed_out);
    INFO(first_message(fragment));
    CHECK(first_message(fragment).find("waits for something: no answer came within 5 s; the solution needs") !=
          std::string::npos);
}

TEST_CASE("a fragment that takes all memory or starts programs is told so") {
    const FragmentRecord memory = graded_mirror(
        mirror("static std::vector<char> all; all.resize(3ull << 30, 1); return d;", "#include <vector>\n"));
    CHECK(memory.verdict == Verdict::crashed);
    INFO(first_message(memory));
    CHECK(first_message(memory).find("uses more than 2 GB of memory") != std::string::npos);
    for (const std::string start : {"while (true) fork();", "(void)!std::system(\"true\");", "vfork();"}) {
        const FragmentRecord fragment = graded_mirror(mirror(start + " return d;", "#include <unistd.h>\n"));
        CHECK(fragment.verdict == Verdict::crashed);
        INFO(first_message(fragment));
        CHECK(first_message(fragment).find("starts other programs") != std::string::npos);
    }
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

TEST_CASE("a fragment that returns NaN is told for which arguments") {
    const FragmentRecord fragment = graded_mirror(mirror("return d / (dot(d, n) - dot(n, d));"));
    const std::string message = first_message(fragment);
    INFO(message);
    // d / 0 is inf or nan
    CHECK(fragment.verdict != Verdict::passed);
    const FragmentRecord nan = graded_mirror(mirror("return d * std::sqrt(-1.0 - dot(d, d));", "#include <cmath>\n"));
    CHECK(nan.verdict == Verdict::not_finite);
    CHECK(first_message(nan).starts_with("mirror_direction returned nan: look for 0/0"));
}

TEST_CASE("a fragment that keeps state is told so") {
    const FragmentRecord fragment = graded_mirror(mirror("static double k = 1; k *= 1.5; return k * d;"));
    CHECK(fragment.verdict == Verdict::failed);
    INFO(first_message(fragment));
    CHECK(first_message(fragment).find("again with the same arguments") != std::string::npos);
}

TEST_CASE("a wrong fragment fails with the hint of its statistic") {
    const FragmentRecord fragment = graded_mirror(mirror("return d - dot(d, n) * n;"));
    CHECK(fragment.verdict == Verdict::failed);
    CHECK(first_message(fragment).starts_with(
        "the answer is `d - dot(d, n) * n`, must be `d - 2 * dot(d, n) * n`\nFor d = "));
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
