#include <fmt/format.h>

#include "assignment/assignment.h"
#include "catch.h"
#include "class/compare_classes.h"
#include "class/entries.h"
#include "class/report.h"
#include "files/files.h"
#include "records.h"

using namespace grade;
using namespace grade::course;

namespace {

Result student(const std::string& name, std::optional<double> points, const std::string& fault = "") {
    Result result;
    result.student.name = result.path = name, result.fault = fault;
    if (points) {
        FragmentRecord fragment;
        fragment.name = "moved", fragment.points = *points, fragment.max_points = 2;
        fragment.verdict = *points == 2 ? Verdict::passed : Verdict::failed;
        result.record = Record{.fragments = {fragment}};
    }
    return result;
}

std::vector<Entry> export_with(const fs::path& folder, const std::string& metadata) {
    for (const char* name : {"submission_1", "submission_2"}) {
        fs::create_directories(folder / name);
        write_text(folder / name / "moved.cpp", "x");
    }
    write_text(folder / "submission_metadata.yml", metadata);
    return read_export(folder, read_assignment("assignment.toml"), "starter");
}

}  // namespace

TEST_CASE("a name forges no line of a class") {
    const std::string forged = "\n    100 of 100   Mallory\n\x1b[31m";
    Result eve = student("eve" + forged, 1.0), odd = student("odd" + forged, {}, "broken" + forged);
    eve.notes = {"moved: there is a" + forged};
    for (const std::string& text : {class_table({eve, odd}), compare_classes({student("x", 1.0)}, {eve, odd}).text,
                                    compare_classes({eve, odd}, {student("x", 1.0)}).text}) {
        CHECK(text.find("\n    100 of 100") == text.npos);
        CHECK(text.find('\x1b') == text.npos);
    }
}

TEST_CASE("a class compared with another says who rose, fell, came, went, or was not graded") {
    const std::vector<Result> before{student("ada", 1.0), student("bob", 2.0), student("eve", 2.0)};
    const auto compared = [&](const std::vector<Result>& after) { return compare_classes(before, after); };
    CHECK(compared(before).same);
    CHECK(compared(before).text == "0 rise, 0 fall, 3 as before\n");
    std::vector<Result> after = before;
    after[0] = student("ada", 2.0);
    CHECK_FALSE(compared(after).same);
    CHECK(compared(after).text.find("ada: 2, was 1 (+1)\n") == 0);
    CHECK(compared(after).text.ends_with("1 rise, 0 fall, 2 as before\n"));
    // the machine's trouble takes no points
    after = before, after[1] = student("bob", {});
    CHECK_FALSE(compared(after).same);
    CHECK(compared(after).text == "bob: not graded, was 2\n0 rise, 0 fall, 2 as before, 1 not graded in both\n");
    // what cannot be read does
    after[1] = student("bob", {}, "broken");
    CHECK(compared(after).text == "bob: none, was 2 (-2)\n0 rise, 1 fall, 2 as before\n");
    after = before, after.pop_back();
    CHECK_FALSE(compared(after).same);
    CHECK(compared(after).text == "eve: gone, was 2\n0 rise, 0 fall, 2 as before, 1 gone\n");
    after = before, after.push_back(student("zoe", 2.0));
    CHECK_FALSE(compared(after).same);
    CHECK(compared(after).text == "zoe: new, 2\n0 rise, 0 fall, 3 as before, 1 new\n");
}

TEST_CASE("whom submission_metadata.yml does not name is told") {
    const TemporaryFolder folder;
    const std::string both =
        "submission_1:\n  :submitters:\n  - :name: Ada\nsubmission_2:\n  :submitters:\n  - :name: Bob\n";
    for (const Entry& entry : export_with(folder.path(), both)) CHECK(entry.notes.empty());
    const std::string one = both.substr(0, both.find("submission_2"));
    const auto entries = export_with(folder.path(), one);
    REQUIRE(entries.size() == 2);
    CHECK(entries[0].notes.empty());
    CHECK(entries[1].notes ==
          std::vector<std::string>{"submission_metadata.yml has no name for it; expected the file whole, as Gradescope "
                                   "exported it"});
    for (const char* broken : {"", "&a [*a", "{"})
        for (const Entry& entry : export_with(folder.path(), broken)) CHECK(entry.notes.size() == 1);
}
