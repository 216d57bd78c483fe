#include <nlohmann/json.hpp>

#include <algorithm>

#include "catch.h"
#include "convert/formats.h"
#include "convert/read_record.h"
#include "diagnosis/diagnosis.h"
#include "records.h"
#include "report/escape.h"
#include "report/json.h"
#include "report/page.h"
#include "report/terminal.h"

using namespace grade;

TEST_CASE("nothing that a submission says gets into the page or the terminal as it is") {
    const std::string hostile = "<script>alert(1)</script>\" onload='x' \033[2J\xff\xe2\x80\xae";
    const Record record = record_with(hostile);
    const std::string text = page(record);
    CHECK(text.find("<script>alert") == std::string::npos);  // but for the one of the page
    CHECK(text.find("onload='x'") == std::string::npos);
    CHECK(text.find('\033') == std::string::npos);
    CHECK(text.find('\xff') == std::string::npos);
    const std::string terminal = table(record, {});
    CHECK(terminal.find('\033') == std::string::npos);
    CHECK(terminal.find("\xe2\x80\xae") == std::string::npos);
    CHECK(nlohmann::json::accept(to_json(record)));
}

TEST_CASE("a terminal tells what is wrong, the call, what to read, and last what the compiler warns of") {
    Record record = record_with("is it squared?");
    FragmentRecord& wrong = record.fragments[0];
    wrong.message.clear(), wrong.checks[0].message.clear(), wrong.checks[1].statistics.clear();
    wrong.file = "fragments/moved.cpp", wrong.warnings = "fragments/moved.cpp:9:5: warning: unused";
    wrong.finding.arguments = "time = -1", wrong.finding.answer = "1", wrong.finding.right = "2";
    wrong.finding.command = "./grade call moved 'time = -1'";
    // one fragment has no sums
    const std::string row = "  moved                   failed              1 of 3    fragments/moved.cpp\n";
    const std::string below = "      For time = -1 the answer is 1, must be 2\n";
    const std::string last = "      read: handout.md, \"moved\"\n      fragments/moved.cpp:9:5: warning: unused\n";
    CHECK(table(record, {}) == row + below + last);
    const std::string again = "      again: ./grade call moved 'time = -1'\n";
    const std::string defaults =
        "Fields that a call does not name have the defaults of starter/rt/parts.h and ray.h.\n";
    CHECK(table(record, {.own = true}) == row + below + again + last + defaults);
    // files are named as they are from where the reader stands
    const std::string text = table(record, {.own = true, .folder = "../starter/"});
    CHECK(text.find(" ../starter/fragments/moved.cpp\n") != text.npos);
    CHECK(text.find(" ../starter/fragments/moved.cpp:9:5: warning: unused\n") != text.npos);
    // what does not fit has the answers in lines of their own
    Record long_call = record;
    long_call.fragments[0].finding.arguments = "camera.focus = 3, pinhole.direction = (0.123456, 0.234567, 0.345678)";
    long_call.fragments[0].finding.answer = "origin = (0, 0, 1)",
    long_call.fragments[0].finding.right = "origin = (0, 1, 1)";
    CHECK(table(long_call, {})
              .find("0.345678)\n      the answer is origin = (0, 0, 1),\n      must be origin = (0, 1, 1)\n") !=
          std::string::npos);
    // of several, those of parts where there are several
    FragmentRecord blank;
    blank.name = "phong", blank.part = "one", blank.max_points = 3, blank.verdict = Verdict::not_started;
    blank.message = "fill in fragments/phong.cpp";
    record.fragments.push_back(blank);
    const std::string second = "  phong                   not started         0 of 3    fill in fragments/phong.cpp\n";
    const std::string total = "Total                                         1 of 6    1 failed, 1 not started\n";
    CHECK(table(record, {}) == row + below + last + second + total);
    record.parts.push_back({"two", "Part two"});
    record.fragments[1].part = "two";
    CHECK(table(record, {}).starts_with("Part one                                      1 of 3\n" + row));
    CHECK(table(record, {}).ends_with("3\n" + second + "\n" + total));
}

TEST_CASE("reports show what a picture costs and how noisy it is, beside the solution's") {
    Record record = record_with("mine");
    CHECK_FALSE(record.efficiency_ratio().has_value());
    CHECK(page(record).find("One picture") == std::string::npos);
    CheckRecord& check = record.fragments[0].checks[0];
    check.cost = PictureCost{4e-4, 0.5};
    check.solution_cost = PictureCost{1e-4, 0.25};
    CHECK(check.cost->rmse() == Approx(0.02));
    CHECK(check.cost->efficiency().value() == Approx(5000));
    // what is wrong has no efficiency
    CHECK_FALSE(record.efficiency_ratio().has_value());
    CHECK(page(record).find("One picture, yours: error 0.02 in 0.5 s of CPU time. The right one: error 0.01") !=
          std::string::npos);
    CHECK(page(record).find("the right one's") == std::string::npos);
    CHECK(table(record, {}).find("Efficiency") == std::string::npos);
    record.fragments[0].verdict = Verdict::passed;
    CHECK(record.efficiency_ratio().value() == Approx(0.125));
    const auto json = nlohmann::json::parse(to_json(record));
    CHECK(json["fragments"][0]["checks"][0]["picture"]["mse"] == Approx(4e-4));
    CHECK(json["fragments"][0]["checks"][0]["solution_picture"]["cpu_seconds"] == Approx(0.25));
    const std::string text = page(record);
    CHECK(text.find("Efficiency: 0.12 times the right one's.") != std::string::npos);
    CHECK(text.find("Error of pictures against run time</text>") != std::string::npos);
    CHECK(table(record, {}).find("0.12 times the solution's") != std::string::npos);

    // without an error there is no efficiency
    check.cost->mse = 0;
    CHECK_FALSE(record.efficiency_ratio().has_value());
}

TEST_CASE("printable text keeps what people write and ends somewhere") {
    CHECK(printable("größer\tals\n§") == "größer\tals\n§");
    CHECK(printable("a\rb\x01"
                    "c") == "ab?c");
    CHECK(printable(std::string(5000, 'x'), 100).size() < 110);
}

TEST_CASE("an annotation stands at the line that is named, by the compiler or by a hint") {
    const auto line = [](const std::string& message) {
        Record record;
        FragmentRecord fragment;
        fragment.name = "moved", fragment.verdict = Verdict::did_not_build, fragment.message = message;
        record.fragments = {fragment};
        const std::string text = annotations(record);
        return text.substr(0, text.find(",title"));
    };
    CHECK(line("fragments/moved.cpp:12:5: error: no") == "::error file=moved.cpp,line=12");
    CHECK(line("it is squared: see line 19") == "::error file=moved.cpp,line=19");
    CHECK(line("a line of words") == "::error file=moved.cpp,line=1");
}

TEST_CASE("the page and the terminal begin with what is begun") {
    Record record = record_with("wrong");
    FragmentRecord blank = record.fragments[0];
    blank.name = "phong", blank.verdict = Verdict::not_started;
    record.fragments.insert(record.fragments.begin(), blank);
    CHECK(page(record).find("Next: <a href=\"#moved\">") != std::string::npos);
    record.fragments.pop_back();
    CHECK(page(record).find("Next: <a href=\"#phong\">") != std::string::npos);
}

TEST_CASE("a record with points below zero is none") {
    Record record = record_with("");
    record.fragments[0].points = -5;
    CHECK_THROWS_WITH(record_of(to_json(record), "r.json"), Catch::Matchers::ContainsSubstring("of at least 0"));
}

TEST_CASE("the calls of a page name whose fragments they are") {
    Record record = record_with("wrong");
    record.fragments[0].finding.code = "moved(p)", record.fragments[0].finding.command = "./grade call moved";
    name_submission_in_calls(record, "'a b'");
    CHECK(page(record).find("./grade call moved --of &#39;a b&#39;") != std::string::npos);
}

TEST_CASE("a name stays on its line") {
    CHECK(printable_line("a\n    100 of 100   Mallory\t\x1b[31m\u202e") == "a?    100 of 100   Mallory??[31m???");
    Record record = {.notes = {"a\nb"}, .changes = {"c\nd"}};
    record.parts = {{"p", "P\n  100 of 100"}, {"q", "Q"}};
    record.fragments = {FragmentRecord{.name = "x\n  100 of 100", .part = "p"},
                        FragmentRecord{.name = "y", .part = "q"}};
    for (const std::string& text : {table(record, {}), annotations(record), actions(record), gradescope(record)})
        for (const char* forged : {"\n  100 of 100", "\nb", "\nd"}) CHECK(text.find(forged) == text.npos);
}

TEST_CASE("printable text is no command to who runs the grader") {
    CHECK(printable("::error::a rt::phong\n  ::set-env x::y") == ": :error::a rt::phong\n  : :set-env x::y");
    CHECK(printable("a ##[error]b") == "a # #[error]b");
}

TEST_CASE("points are the share of passed checks") {
    CHECK(record_with("").fragments[0].points == 1);
    FragmentRecord none;
    none.max_points = 3;
    CHECK(points_of(none) == 0);
}

TEST_CASE("the worst verdict of a fragment is told") {
    CHECK(worse(Verdict::passed, Verdict::inconclusive) == Verdict::inconclusive);
    CHECK(worse(Verdict::crashed, Verdict::failed) == Verdict::crashed);
    CHECK(worse(Verdict::inconclusive, Verdict::failed) == Verdict::failed);
}

TEST_CASE("of what fails, shared numbers are told first, then what is no image, tone, geometry, radiometry, variance") {
    std::vector<StatisticRecord> all;
    for (const char* id : {"G3", "L1", "D1", "A1", "G4", "V0", "G1"}) {
        all.insert(all.begin(), failing(id, id));
        std::rotate(all.begin(), all.begin() + 1, all.end());  // the last one is told first
        CHECK(diagnose(fragment_with(Verdict::failed, "", all)).words == (std::string(id) == "A1" ? "D1" : id));
    }
    // what a call shows comes before what a picture shows, but for shared numbers
    FragmentRecord both = fragment_with(Verdict::failed, "", {failing("A1", "picture")});
    both.checks[0].scene = "[camera]";
    both.checks.push_back(fragment_with(Verdict::failed, "", {failing("V3", "call")}).checks[0]);
    CHECK(diagnose(both).words == "call");
    both.checks[0].statistics[0].id = "G1";
    CHECK(diagnose(both).words == "picture");
    // of one family, the first check's
    CHECK(diagnose(fragment_with(Verdict::failed, "", {failing("A1", "first"), failing("D1", "second")})).words ==
          "first");
    // a crash comes before all statistics
    FragmentRecord crashed = fragment_with(Verdict::failed, "", {failing("G1", "shared")});
    crashed.checks.push_back(crashed.checks[0]);
    crashed.checks[1].verdict = Verdict::crashed, crashed.checks[1].message = "ended",
    crashed.checks[1].statistics.clear();
    CHECK(diagnose(crashed).words == "ended");
    CHECK(diagnose(crashed).section == "lens_ray");
}

TEST_CASE("a diagnosis says where to read, in the record, in the table and as a link") {
    const FragmentRecord wrong =
        fragment_with(Verdict::failed, "", {failing("D1", "the blur disc is 2.01 times what it must be")});
    CHECK(diagnose(wrong).section == "lens_ray");
    CHECK(reading("lens_ray") == "handout.md, \"lens_ray\"");
    CHECK(anchor("What to use instead of an epsilon") == "what-to-use-instead-of-an-epsilon");
    const auto in_trouble = [](Verdict verdict, Trouble trouble) {
        FragmentRecord fragment = fragment_with(verdict, "words", {});
        fragment.checks[0].trouble = trouble;
        return diagnose(fragment).section;
    };
    CHECK(in_trouble(Verdict::not_finite, Trouble::not_a_number) == "lens_ray");  // its pitfalls say where from
    CHECK(in_trouble(Verdict::not_finite, Trouble::no_radiance) == pictures_section);
    CHECK(in_trouble(Verdict::failed, Trouble::keeps_state) == rules_section);
    CHECK(in_trouble(Verdict::failed, Trouble::no_radiance) == pictures_section);
    CHECK(diagnose(fragment_with(Verdict::failed, "", {failing("V0", "changes")})).section == rules_section);
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {wrong};
    record.fragments[0].part = "one";
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0]["read"] == "handout.md, \"lens_ray\"");
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0]["checks"][0]["statistics"][0]["read"] ==
          "handout.md, \"lens_ray\"");
    CHECK(table(record, {}).find("handout.md, \"lens_ray\"") != std::string::npos);
    CHECK(page(record, "../handout.md").find("href=\"../handout.md#lens_ray\"") != std::string::npos);
    record.fragments = {fragment_with(Verdict::passed, "", {})};
    CHECK(!nlohmann::json::parse(to_json(record))["fragments"][0].contains("read"));
}

TEST_CASE("the compiler's warnings are in the table, on the page and in the record, also of what passes") {
    Record record;
    record.parts = {{"one", "Part one"}};
    record.fragments = {fragment_with(Verdict::passed, "", {})};
    record.fragments[0].part = "one";
    record.fragments[0].warnings = "phong.cpp:4:9: warning: unused <b>variable</b> [-Wunused-variable]\x1b[31m\n";
    const std::string rows = table(record, {}), text = page(record, "../handout.md");
    CHECK(rows.find("phong.cpp:4:9: warning: unused <b>variable</b>") != std::string::npos);
    CHECK(rows.find('\x1b') == std::string::npos);
    CHECK(text.find("&lt;b&gt;variable") != std::string::npos);
    CHECK(text.find("<b>variable") == std::string::npos);
    CHECK(nlohmann::json::parse(to_json(record))["fragments"][0].contains("warnings"));
}

TEST_CASE("a record that is read again says the same, and where to read about it") {
    Record record;
    FragmentRecord no_number = fragment_with(Verdict::not_finite, "a nan", {});
    no_number.checks[0].trouble = Trouble::not_a_number;
    no_number.finding.how = "some are nan; it is too large", no_number.finding.of_numbers = "it is too large";
    StatisticRecord sure = failing("L3", "it is squared: 4; expected 2");
    sure.without_numbers = "it is squared", sure.worth = StatisticRecord::Worth::cause, sure.chi_squared = true;
    FragmentRecord squared = fragment_with(Verdict::failed, "", {sure});
    squared.finding.how = "another";
    FragmentRecord blank = fragment_with(Verdict::not_started, "", {});
    blank.message = "fill it in";
    record.fragments = {no_number, squared, blank, fragment_with(Verdict::passed, "", {})};
    const Record again = record_of(to_json(record), "record.json");
    REQUIRE(again.fragments.size() == record.fragments.size());
    for (std::size_t i = 0; i < again.fragments.size(); ++i) {
        const Diagnosis first = diagnose(record.fragments[i]), second = diagnose(again.fragments[i]);
        CHECK(second.words == first.words);
        CHECK(second.section == first.section);
        CHECK(again.fragments[i].message == record.fragments[i].message);
    }
    CHECK(again.fragments[1].checks[0].statistics[0].chi_squared);
}
