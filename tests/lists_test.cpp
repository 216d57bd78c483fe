#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <stdexcept>

#include "assignment/assignment.h"
#include "catch.h"
#include "checks/kit/check.h"
#include "child/probes.h"
#include "files/files.h"
#include "protocol/width.h"

using namespace grade;
using Catch::Matchers::EndsWith;

namespace {

/// The functions that a header declares, but for report_not_started.
std::set<std::string> declared(const std::string& path) {
    const std::string text = read_text(path).value();
    const std::regex declaration("\\n[A-Za-z][^\\n;(]* (\\w+)\\([^;{]*\\);");
    std::set<std::string> names;
    for (std::sregex_iterator match(text.begin(), text.end(), declaration), end; match != end; ++match)
        names.insert((*match)[1]);
    names.erase("report_not_started");
    return names;
}

/// The files of a folder, without .cpp.
std::set<std::string> sources(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".cpp") names.insert(entry.path().stem());
    return names;
}

}  // namespace

TEST_CASE(
    "what the assignment lists is declared in fragments.h, with a solution, a blank and a file of checks for each") {
    const std::set<std::string> fragments = declared("starter/rt/fragments.h");
    const auto names = read_assignment("assignment.toml").names();
    for (const std::string& name : names) CHECK(fragments.contains(name));
    CHECK(sources("solution") == fragments);
    CHECK(sources("starter/fragments") == fragments);
    CHECK(sources("grader/checks") == fragments);
}

TEST_CASE("a mistake in the assignment is told with its place, and what is meant") {
    const std::string text = read_text("assignment.toml").value(),
                      entry = "{ name = \"integrate_uniform\", points = 2 }";
    const std::string parts = text.substr(text.find("[[part]]")), part = "[[part]]\nname = \"a\"\ntitle = \"A\"\n";
    const std::size_t at = text.find(entry);
    REQUIRE(at != text.npos);
    const std::string line = std::to_string(1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "a.toml").string();
    const auto complaint = [&](const std::string& from, const std::string& to) -> std::string {
        std::string changed = text;
        const std::size_t begin = changed.find(from);
        REQUIRE(begin != changed.npos);
        write_text(path, changed.replace(begin, from.size(), to));
        const std::string words = complaint_of([&] { (void)read_assignment(path, fragments_in("solution")); });
        return words.empty() ? words : words.substr(path.size() + 1);
    };
    CHECK(complaint(entry, entry).empty());
    CHECK(complaint(entry, "{ name = \"integrate_unifrom\", points = 2 }") ==
          line + ":12: unknown fragment 'integrate_unifrom'; expected 'integrate_uniform'?");
    CHECK(complaint(entry, "{ name = \"x\", points = 2 }") ==
          line + ":12: unknown fragment 'x'; expected one that starter/rt/fragments.h declares");
    CHECK(complaint(entry, "{ name = \"integrate_uniform\" }") ==
          line + ":3: 'points' is missing in an entry of 'part.fragments'; expected points = ...");
    CHECK(complaint(entry, "\"integrate_uniform\"") ==
          line + ":3: 'fragments' holds a string; expected fragments = [{ ... }, ...]");
    for (const char* points : {"-1", "1001", "nan", "\"2\"", "true"})
        CHECK_THAT(complaint(entry, std::string("{ name = \"integrate_uniform\", points = ") + points + " }"),
                   EndsWith("; expected a number from 0 to 1000"));
    CHECK_THAT(complaint(entry, "{ name = \"integrate_uniform\", point = 2 }"), EndsWith("expected 'points'?"));
    CHECK_THAT(complaint(entry, "{ name = \"integrate_uniform\", points = 4, given = true }"),
               EndsWith("is of a fragment that is handed out filled in; expected no points, or given = false"));
    CHECK(complaint(entry, "{ name = \"integrate_uniform\", points = 0, given = true }").empty());
    CHECK_THAT(complaint(entry, "{ name = \"phong\", points = 2 }"),
               EndsWith(": a second fragment 'phong'; expected each name once"));
    CHECK_THAT(complaint("fragments = [", "fragment = ["), EndsWith("expected 'fragments'?"));
    CHECK_THAT(complaint("name = \"sampling\"", "name = \"whitted\""),
               EndsWith("a second part 'whitted'; expected each name once"));
    CHECK_THAT(complaint(parts, ""), EndsWith("expected [[part]], once for each"));
    CHECK_THAT(complaint(parts, part),
               EndsWith("'fragments' is missing in [[part]]; expected fragments = [{ ... }, ...]"));
    CHECK_THAT(complaint(parts, part + "fragments = []\n"),
               EndsWith("no part has a fragment; expected { name = ..., points = ... }"));
}

TEST_CASE("each fragment has a probe, a check, and points unless it is given") {
    const auto checks = all_checks(1);
    for (const Fragment& fragment : read_assignment("assignment.toml").fragments) {
        CAPTURE(fragment.name);
        CHECK_THROWS_AS(probe(fragment.name, {}), std::out_of_range);  // the row is too short
        CHECK(std::ranges::count(checks, fragment.name, &Check::fragment) > 0);
        CHECK((fragment.points > 0) != fragment.given);
    }
    CHECK_THROWS_AS(probe("no_such", {}), std::invalid_argument);
}

TEST_CASE("how many numbers an answer has is known of each fragment: those that its checks' calls get") {
    for (const Check& check : all_checks(1)) {
        const Probe* calls = std::get_if<Probe>(&check.experiment);
        if (!calls) continue;
        INFO(check.fragment << "." << check.name);
        Generator random(1);
        CHECK(probe(check.fragment, calls->inputs(random).front()).size() == width_of(check.fragment));
    }
    CHECK(width_of("nobody") == 0);
}
