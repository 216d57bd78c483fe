#include "catch.h"
#include "diagnosis/diagnosis.h"
#include "graded.h"
#include "judging/own_picture.h"
#include "report/json.h"

using namespace grade;
using namespace grade::small;

namespace {

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
     Verdict::did_not_build,
     "signature differs from fragments.h:\n    here         rt::mirror_direction(vec3 const&, vec3)"},
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
     "nan begins with `sqrt(-1.0 - dot(d, d))` in line 7, the root of a negative number"},
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

TEST_CASE("a fragment that does not compile shows the first error with file and line") {
    const FragmentRecord fragment = graded_mirror(mirror("return d - 2.0 * dot(d, normal) * n;"));
    CHECK(fragment.verdict == Verdict::did_not_build);
    INFO(fragment.message);
    CHECK(fragment.message.starts_with("mirror_direction.cpp:6:"));
    CHECK(fragment.message.find("normal") != std::string::npos);
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
    CHECK(first_message(fragment).starts_with("with `2 * dot(d, n)` in place of `dot(d, n)` in line 6, "));
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

TEST_CASE("a picture is drawn once for the same program, also where none came in its time") {
    const TemporaryFolder folder;
    const auto drawn = [&](const std::string& text) {
        BuildSettings build;
        build.kept = Kept(folder.path(), toolchain());
        Progress progress(nullptr);
        Programs programs(submission({{"mirror_direction", text}}), toolchain(), build, progress);
        programs.compile({"mirror_direction"});
        return draw_compared(programs, programs.must_link({"mirror_direction"}), "scenes/mirror.toml",
                             {1, {16, 16}, 1, 1});
    };
    const std::string good = solution("mirror_direction"), endless = mirror("for (;;) d.x += 1;");
    const Compared first = drawn(good), again = drawn(good);
    CHECK((first.mine.seconds > 0 && first.right.seconds > 0));
    CHECK((again.mine.seconds == 0 && again.right.seconds == 0));
    CHECK(again.mine.image.pixels == first.mine.image.pixels);
    CHECK(first.mine.image.pixels == first.right.image.pixels);
    CHECK(drawn("\n" + good).mine.seconds == 0);  // the same program

    const std::string late = drawn(endless).mine.fault;
    CHECK(late == "ran longer than 1 s");
    CHECK(drawn(endless).mine.fault == late);
    CHECK(drawn(good).mine.seconds > 0);  // the last one alone is kept
}
