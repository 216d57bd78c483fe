#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

#include "assignment/assignment.h"
#include "catch.h"
#include "checks/kit/check.h"
#include "child/probes.h"
#include "files/files.h"
#include "protocol/width.h"

using namespace grade;

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
