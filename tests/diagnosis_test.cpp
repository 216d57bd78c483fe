#include <fstream>
#include <iterator>
#include <random>
#include <regex>

#include "catch.h"
#include "checks/kit/draw.h"
#include "checks/kit/probe_check.h"
#include "child/probes.h"
#include "diagnosis/diagnosis.h"
#include "diagnosis/explain.h"
#include "protocol/rows.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

namespace {

std::string header() {
    std::ifstream file("starter/rt/fragments.h");
    return {std::istreambuf_iterator<char>(file), {}};
}

Signature declared(const std::string& fragment) { return signature_of(fragment, header()).value(); }

/// The answers of the solution, or of it with a mistake: made of its arguments, or of its answer.
Ask answers(const std::string& fragment, std::function<void(Row&)> arguments = {},
            std::function<void(Row&)> answer = {}) {
    return [=](const Rows& rows) {
        Rows all;
        for (Row row : rows) {
            if (arguments) arguments(row);
            Row out = probe(fragment, row);
            if (answer) answer(out);
            all.push_back(out);
        }
        return all;
    };
}

Finding found(const std::string& fragment, const Rows& rows, const Ask& mine) {
    return explain(declared(fragment), rows, mine, answers(fragment));
}

/// So many calls, each drawn anew.
template <class F>
Rows calls(F draw, int count = 60) {
    Generator random(3);
    return rows_of(count, draw)(random);
}

Rows mirrors() {
    return calls([](Generator& random) { return row(box(random, -3, 3), direction(random)); });
}

Rows squares() {
    return calls([](Generator& random) { return row(square(random)); });
}

}  // namespace

TEST_CASE("each declaration of fragments.h is read, and says what a row of it holds") {
    const std::string text = header();
    const std::regex declaration("^[A-Za-z]\\S* ([a-z_0-9]+)\\(.*\\);$", std::regex::multiline);
    int count = 0;
    for (auto found = std::sregex_iterator(text.begin(), text.end(), declaration); found != std::sregex_iterator();
         ++found) {
        const std::string name = (*found)[1];
        if (name == "report_not_started") continue;
        const Signature signature = declared(name);
        const Row blank = signature.blank();
        INFO(name);
        CHECK_FALSE(signature.arguments.empty());
        CHECK_NOTHROW(signature.of_arguments(blank));
        CHECK_THROWS(signature.of_arguments(Row(blank.begin(), blank.end() - 1)));
        if (signature.of_arguments(blank).lists.empty() && signature.arguments[0].type != "Function")
            CHECK_NOTHROW(probe(name, blank));
        ++count;
    }
    CHECK(count > 30);
}

TEST_CASE("arguments are printed by name, without those at their defaults, and read again") {
    const Signature camera = declared("camera_ray");
    rt::Camera some;
    some.size = {2, 2}, some.focus = rt::inf;
    const Row told = row(some, rt::vec2(0, 0.5));
    CHECK(arguments_in_words(camera, told) == "camera.size = (2, 2), film = (0, 0.5)");
    CHECK(arguments_from_words(camera, arguments_in_words(camera, told)) == told);
    CHECK_THROWS_WITH(arguments_from_words(camera, "camera.size = 2"),
                      ContainsSubstring("camera.size is 1 numbers; expected 2"));
    CHECK_THROWS_WITH(arguments_from_words(camera, "size = (2, 2)"), ContainsSubstring("camera.tan_half_fov"));
    const Signature light = declared("light_sample");
    CHECK_THAT(arguments_in_words(light, arguments_from_words(light, "light.kind = disc, p = (0, 0, 1)")),
               ContainsSubstring("light.kind = disc"));
}

TEST_CASE("a mistake in the arguments of any formula is named") {
    const auto exchanged = [](Row& in) { std::swap_ranges(in.begin(), in.begin() + 3, in.begin() + 3); };
    CHECK_THAT(found("mirror_direction", mirrors(), answers("mirror_direction", exchanged)).how,
               ContainsSubstring("`d` and `n` exchanged"));
    const auto one_number = [](Row& in) { in[1] = in[0]; };
    CHECK_THAT(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", one_number)).how,
               ContainsSubstring("`u.x` in place of `u.y`"));
    const auto no_root = [](Row& in) { in[0] *= in[0]; };
    CHECK_THAT(found("uniform_disk", squares(), answers("uniform_disk", no_root)).how,
               ContainsSubstring("`u.x * u.x` in place of `u.x`"));
    const auto two = [](Row& in) { in[0] = std::sqrt(in[0]), in[1] /= 2; };
    const std::string both = found("uniform_disk", squares(), answers("uniform_disk", two)).how;
    CHECK_THAT(both, ContainsSubstring("`sqrt(u.x)`"));
    CHECK_THAT(both, ContainsSubstring("`u.y / 2`"));
}

TEST_CASE("a mistake in the answer is named, with constants by their names and ratios that are not 1") {
    const auto density = [](double factor) { return [factor](Row& out) { out.back() *= factor; }; };
    CHECK(found("uniform_disk", squares(), answers("uniform_disk", {}, density(rt::pi))).how ==
          "`density` is pi times too large");
    CHECK(found("uniform_disk", squares(), answers("uniform_disk", {}, density(1.005))).how ==
          "`density` is 1.005 times too large");
    const auto towards = [](Row& out) { std::swap(out[1], out[2]); };
    CHECK(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", {}, towards)).how ==
          "`direction` has y and z exchanged");
    const auto cosine = [](Row& out) { out.back() *= out[2]; };
    CHECK_THAT(found("cosine_hemisphere", squares(), answers("cosine_hemisphere", {}, cosine)).how,
               ContainsSubstring("the answer's direction.z"));
}

TEST_CASE("what is as good as right is not called wrong") {
    const auto turned = [](Row& in) { in[0] = 1 - in[0]; };
    const Finding finding = found("uniform_disk", squares(), answers("uniform_disk", turned));
    CHECK(finding.how.empty());
    CHECK(finding.arguments.empty());
}

TEST_CASE("where calls are wrong, and the simplest of them") {
    const Rows rows = calls(
        [](Generator& random) { return row(box(random, -5, 5), box(random, -3, 3), between(random, -2, 4)); }, 120);
    const auto clamped = [](Row& in) { in[6] = std::max(in[6], 0.0); };
    const Finding finding = found("moved", rows, answers("moved", clamped));
    CHECK_THAT(finding.how, ContainsSubstring("`max(time, 0)` in place of `time`"));
    CHECK_THAT(finding.where, ContainsSubstring("`time < 0`"));
    CHECK(finding.arguments == "point = (0, 0, 1), velocity = (0, 0, 1), time = -1");
    CHECK(finding.answer == "(0, 0, 1)");
    CHECK(finding.right == "(0, 0, 0)");
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
    fragment.checks[0].statistics[0].exact = true;
    CHECK(diagnose(fragment).words.starts_with("guess\nwhere\n"));
    fragment.checks[0].statistics[0].hint = "6 of 9 calls are wrong; for arguments (1) the result is (2), expected (3)";
    fragment.finding.how.clear();
    CHECK(diagnose(fragment).words.starts_with("where\n"));
}
