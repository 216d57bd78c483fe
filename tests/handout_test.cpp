#include <fmt/format.h>

#include <filesystem>
#include <regex>

#include "assignment/assignment.h"
#include "catch.h"
#include "checks/kit/check.h"
#include "diagnosis/diagnosis.h"
#include "files/files.h"
#include "judging/grading.h"
#include "report/describe.h"
#include "report/scene_tables.h"
#include "rt/files/scene_keys.h"
#include "secrets.h"

using namespace grade;

namespace {

const std::string& handout() {
    static const std::string text = read_text("handout.md").value();
    return text;
}

/// First groups of all matches.
std::vector<std::string> found(const std::string& text, const std::string& pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator match(text.begin(), text.end(), regex), end; match != end; ++match)
        all.push_back((*match)[1]);
    return all;
}

}  // namespace

TEST_CASE("the handout's tables of points and checks are what the program gives") {
    INFO("make them anew: build/release/grader/grade describe --update handout.md");
    CHECK(with_new_tables(handout(), read_assignment("assignment.toml"), "handout.md") == handout());
}

TEST_CASE("the handout has a section with a table for each fragment, in the order of the assignment") {
    const auto names = read_assignment("assignment.toml").names();
    std::vector<std::string> tables = found(handout(), "<!-- checks: (\\w+) -->");
    std::erase_if(tables, [&](const std::string& name) { return std::ranges::count(names, name) == 0; });
    CHECK(tables == names);
    std::vector<std::string> sections;
    for (const auto& title : found(handout(), "\n### (\\w+)\n"))
        if (std::find(names.begin(), names.end(), title) != names.end()) sections.push_back(title);
    CHECK(sections == names);
}

TEST_CASE("each fragment of the handout has a question, and those who teach an answer") {
    const auto names = read_assignment("assignment.toml").names();
    std::vector<std::string> answers = found(read_text("grader/THINK.md").value(), "\n### (\\w+)\n\n[^\n#]");
    CHECK(found(handout(), "\n(\\*\\*Think:\\*\\*) ").size() == answers.size());
    std::erase_if(answers, [&](const std::string& name) { return std::ranges::count(names, name) == 0; });
    CHECK(answers == names);
}

TEST_CASE("the handout explains each kind of statistic") {
    for (const Check& check : all_checks(1))
        for (const Statistic& statistic : check.statistics) {
            INFO(check.fragment << ", " << check.name);
            CHECK(handout().find("\n| " + statistic.id + " | ") != std::string::npos);
        }
}

TEST_CASE("each statistic has a family, and each section to which a hint sends is in the handout") {
    std::vector<std::string> sections = read_assignment("assignment.toml").names();
    for (const auto section : {rules_section, numbers_section, verdicts_section, pictures_section})
        sections.emplace_back(section);
    for (const std::string& section : sections) {
        INFO(section);
        CHECK(std::regex_search(handout(), std::regex("\n##+ " + section + "\n")));
    }
    for (const Check& check : all_checks(1))
        for (const Statistic& statistic : check.statistics) CHECK_NOTHROW(subject_of(statistic.id));
    CHECK(subject_of("L2") == Subject::factor);
    CHECK_THROWS_AS(subject_of("Z9"), std::out_of_range);
}

TEST_CASE("the schema of scenes is what the program gives, and the handout has each of their tables") {
    INFO("make it anew: build/release/grader/grade describe --update scenes/scene.schema.json");
    CHECK(scene_schema() == read_text("scenes/scene.schema.json"));
    for (const rt::KeyTable& table : rt::scene_tables()) {
        const std::string name(table.name.empty() ? "file" : table.name.substr(0, table.name.find('.')));
        CHECK(handout().find("<!-- keys: " + name + " -->") != std::string::npos);
    }
    CHECK(describe_keys("no_such").empty());
}

TEST_CASE("the handout documents each option of raytrace and grade") {
    for (const char* file : {"starter/raytrace.cpp", "grader/commands/grading.cpp"})
        for (const auto& option :
             found(read_text(file).value(), "app\\.add_(?:option|flag)\\(\"(?:-o,)?(--[\\w-]+)\"")) {
            if (option == "--toolchain" || option == "--out") continue;
            INFO(option);
            CHECK(handout().find("`" + option) != std::string::npos);
        }
}

TEST_CASE("the handout has the grader's own limit of time") {
    const std::string row = "| `--time-limit SECONDS` | CPU time for one answer of a fragment; default ";
    CHECK(handout().find(row + fmt::format("{:g} |\n", GradingSettings{}.time_limit)) != std::string::npos);
}

TEST_CASE("the handout's and the README's pictures and files are there") {
    for (const char* page : {"handout.md", "README.md"})
        for (const auto& path : found(read_text(page).value(), "\\]\\(([\\w./-]+)(?:#[\\w-]*)?\\)")) {
            INFO(page << ": " << path);
            CHECK(fs::exists(path));
        }
}

TEST_CASE("the handout holds no line of what a student must write") {
    for (const auto& [line, path] : secrets()) {
        INFO(path << ": " << line);
        CHECK(handout().find("\n" + line + "\n") == std::string::npos);
        CHECK(handout().find("`" + line + "`") == std::string::npos);
    }
}

TEST_CASE("what a course gives or leaves out is neither counted nor has checks in the handout") {
    Assignment assignment = read_assignment("assignment.toml");
    const std::string all = std::to_string(assignment.asked().size());
    const std::string text = "in <!-- count -->9<!-- end --> parts\n";
    CHECK(with_new_tables(text, assignment, "h.md") == "in <!-- count -->" + all + "<!-- end --> parts\n");

    Fragment& given = assignment.fragments.front();
    given.given = true, given.points = 0;
    const std::string dropped = assignment.fragments.back().name;
    assignment.fragments.pop_back();
    CHECK(assignment.asked().count(given.name) == 0);
    CHECK(with_new_tables(text, assignment, "h.md").find(std::to_string(assignment.fragments.size() - 1) + "<") !=
          std::string::npos);
    CHECK(describe_checks(assignment, given.name).starts_with("Given: "));
    CHECK(describe_checks(assignment, dropped).starts_with("Not part of this assignment: "));
    CHECK(describe_points(assignment).find(dropped) == std::string::npos);
    const std::string block = "<!-- checks: " + dropped + " -->\n<!-- end -->\n";
    CHECK(with_new_tables(block, assignment, "h.md").find("Not part of this assignment") != std::string::npos);
}

TEST_CASE("a handed-out handout lacks the sections of what a course leaves out") {
    Assignment assignment = read_assignment("assignment.toml");
    CHECK(handed_out(handout(), assignment, "h.md") == handout());
    assignment.fragments.erase(assignment.fragments.begin() + std::ptrdiff_t(assignment.place("moved")));
    const std::string part = assignment.fragments.front().part;
    std::erase_if(assignment.fragments, [&](const Fragment& fragment) { return fragment.part == part; });
    const std::string text = handed_out(handout(), assignment, "h.md");
    for (const char* gone : {"\n### moved\n", "\n### integrate_uniform\n", "\n<!-- checks: integrate_stratified -->\n"})
        CHECK(text.find(gone) == std::string::npos);
    CHECK(text.find("\n## Part 1: numerical integration\n\nNot part of this assignment") != std::string::npos);
    std::vector<std::string> sections;
    for (const auto& title : found(text, "\n### (\\w+)\n"))
        if (std::ranges::count(assignment.names(), title) > 0) sections.push_back(title);
    CHECK(sections == assignment.names());
    CHECK(text.substr(text.find("\n## The grader\n")) == handout().substr(handout().find("\n## The grader\n")));
}

TEST_CASE("a block without end and an unknown fragment are errors with their line") {
    const Assignment assignment = read_assignment("assignment.toml");
    const auto error = [&](const std::string& text) {
        return complaint_of([&] { with_new_tables(text, assignment, "h.md"); });
    };
    CHECK(error("a\n<!-- points -->\n").rfind("h.md:2:1: this block has no end", 0) == 0);
    CHECK(error("<!-- checks: no_such -->\n<!-- end -->\n").rfind("h.md:1:1: no fragment is named \"no_such\"", 0) ==
          0);
    const std::string other = "<!-- a comment -->\ntext\n";
    CHECK(with_new_tables(other, assignment, "h.md") == other);
}
