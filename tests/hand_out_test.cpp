#include "hand_out/hand_out.h"

#include <fstream>
#include <map>
#include <sstream>

#include "assignment/assignment.h"
#include "assignment/strip.h"
#include "catch.h"
#include "files/files.h"
#include "files/words.h"
#include "programs/process.h"
#include "programs/toolchain.h"
#include "submission/code_only.h"

using namespace grade;

namespace {

std::string text_at(const fs::path& path) { return read_text(path).value(); }

/// Built by the target grade_kit; where it is not, there is nothing to hand out.
fs::path built_kit() { return fs::path(GRADE_TOOLCHAIN).parent_path() / "kit.toml"; }

/// Every name that an object defines, for itself or for others.
std::vector<std::string> names_in(const fs::path& object) {
    const Ending nm =
        run({"/usr/bin/nm", "--debug-syms", "--defined-only", "--format=posix", object.string()}, Limits{}, "/");
    REQUIRE(nm.good());
    std::vector<std::string> names;
    std::istringstream lines(nm.out);
    for (std::string line; std::getline(lines, line);) names.push_back(line.substr(0, line.find(' ')));
    return names;
}

/// Of an object of the solution no name is left but the fragment's, and nothing tells what it was made from.
void check_traces(const fs::path& object, const std::string& symbol) {
    INFO(object);
    for (const std::string& name : names_in(object)) {
        INFO(name);  // sections, and numbers in place of names
        CHECK((name.starts_with(".") || name == symbol));
    }
    const std::string bytes = text_at(object);
    for (const char* trace : {".debug_", "GCC: (", "solution", "/work/", "BEGIN"}) {
        INFO(trace);
        CHECK(bytes.find(trace) == std::string::npos);
    }
}

/// By line that a student must write, each comment and each string among them: its file.
std::map<std::string, std::string> lines_to_write(const Assignment& assignment) {
    std::map<std::string, std::string> origin;
    for (const Fragment& fragment : assignment.fragments) {
        if (fragment.given) continue;
        const std::string solution = "solution/" + fragment.name + ".cpp";
        for (const std::string& line : find_region(text_at(solution), solution).region)
            if (const std::string text = trimmed(line); code_only(text).size() > 8 || text.starts_with("//"))
                origin[text] = solution;
    }
    return origin;
}

/// Those for who teaches, a paragraph each.
std::vector<std::string> answers() {
    std::vector<std::string> all;
    std::istringstream paragraphs(text_at("grader/THINK.md"));
    for (std::string line; std::getline(paragraphs, line);)
        if (line.size() > 80) all.push_back(line);
    REQUIRE(all.size() > 32);
    return all;
}

void holds_no_answer(const fs::path& path, const std::string& text) {
    static const std::vector<std::string> all = answers();
    for (const std::string& answer : all)
        if (text.find(answer) != text.npos) FAIL_CHECK(path << " holds an answer: " << answer);
}

/// A compiler may hold a long text in pieces of eight bytes.
void tells_not_where_it_was_built(const fs::path& path, const std::string& text) {
    INFO(path);
    const std::string built_in = fs::absolute(".").lexically_normal().parent_path().string();
    CHECK(text.find(built_in) == std::string::npos);
    const bool is_program = text.find('\0') != std::string::npos;
    if (is_program && built_in.size() >= 16) CHECK(text.find(built_in.substr(8, 8)) == std::string::npos);
}

/// The framework may say the same somewhere as a part of a longer line; a whole line may not.
void holds_no_line_of(const std::map<std::string, std::string>& origin, const fs::path& path, const std::string& text) {
    const bool is_source = path.extension() == ".cpp" || path.extension() == ".h";
    for (const auto& [line, file] : origin) {
        const std::size_t at = text.find(line);
        if (at == text.npos) continue;
        const std::size_t start = text.rfind('\n', at) + 1, end = text.find('\n', at);
        const bool whole = !is_source || trimmed(text.substr(start, end - start)) == line;
        INFO(path << " holds a line of " << file << ": " << line);
        CHECK_FALSE((whole && path.extension() != ".md" && path.string().find("/glm/") == std::string::npos));
    }
}

}  // namespace

TEST_CASE("students get a kit") {
    const Assignment assignment = read_assignment("assignment.toml");
    const TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "handed_out", machine = folder / "grader" / kind_of_machine();
    hand_out(".", assignment, built_kit(), folder);
    // what the editor's settings name
    for (const char* schema : {"scenes/scene.schema.json", "grader/assignment/assignment.schema.json"}) {
        CHECK(text_at(folder / ".vscode/settings.json").find(schema) != std::string::npos);
        CHECK(fs::exists(folder / schema));
    }

    for (const char* there :
         {"grade", "handout.md", "scenes/whitted.toml", "starter/rt/math.h", "grader/include/glm/glm.hpp"})
        CHECK(fs::is_regular_file(folder / there));
    for (const char* there : {"grade", "grade_studies", "libchild.a", "librt.a", "reference/phong.o", "toolchain.toml"})
        CHECK(fs::is_regular_file(machine / there));
    for (const Fragment& fragment : assignment.fragments) {
        const std::string file = fragment.name + ".cpp", blank = text_at(folder / "grader/blanks" / file);
        INFO(fragment.name);
        CHECK(text_at(folder / "starter/fragments" / file) == blank);
        if (!fragment.given) CHECK(blank.find("not_started(") != std::string::npos);
    }
}

TEST_CASE("a kit goes into a folder that is named from where one stands") {
    const Assignment assignment = read_assignment("assignment.toml");
    const TemporaryFolder temporary;
    const fs::path project = fs::current_path();
    fs::create_directory(temporary.path() / "empty");
    for (const char* folder : {"kit", "kits/of_autumn/", "empty"}) {
        fs::current_path(temporary.path());
        CHECK_NOTHROW(hand_out(project, assignment, built_kit(), folder));
        fs::current_path(project);
        INFO(folder);
        CHECK(fs::is_regular_file(temporary.path() / folder / "grader" / kind_of_machine() / "grade"));
    }
    CHECK_FALSE(fs::exists(temporary.path() / "kit.part"));
}

TEST_CASE("nothing of what students must write is in their kit, whatever a file's name") {
    const Assignment assignment = read_assignment("assignment.toml");
    const Toolchain built = read_toolchain(built_kit());
    const TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "handed_out", machine = folder / "grader" / kind_of_machine();
    hand_out(".", assignment, built_kit(), folder);
    for (const char* not_there : {"solution", "tests", "build", ".git", "grader/checks", "scenes/render_pictures"})
        CHECK_FALSE(fs::exists(folder / not_there));

    const std::map<std::string, std::string> origin = lines_to_write(assignment);
    std::uintmax_t bytes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        CHECK(entry.path().filename() != "THINK.md");
        // the page holds the pictures once more, and is there only where pandoc is
        if (entry.path().filename() != "handout.html") bytes += entry.file_size();
        const std::string text = text_at(entry.path());
        holds_no_answer(entry.path(), text);
        tells_not_where_it_was_built(entry.path(), text);
        holds_no_line_of(origin, entry.path(), text);
    }
    CHECK(bytes < 25'000'000);

    for (const auto& [fragment, of_build] : built.solution_objects)
        check_traces(machine / "reference" / (fragment + ".o"), built.symbols.at(fragment));
}

TEST_CASE("nothing is handed out into a folder that holds something") {
    const TemporaryFolder temporary;
    std::ofstream(temporary.path() / "mine.txt") << "do not touch";
    const auto refuses = [&](const std::string& why) {
        CHECK_THROWS_WITH(hand_out(".", read_assignment("assignment.toml"), built_kit(), temporary.path()),
                          temporary.path().string() + ": is not empty" + why + "; expected a new folder");
    };
    refuses("");
    fs::copy_file("assignment.toml", temporary.path() / "assignment.toml");
    refuses(": a kit of this assignment.toml");
    std::ofstream(temporary.path() / "assignment.toml", std::ios::app) << "# other points\n";
    refuses(": a kit of another assignment.toml than today's, which stays as it is");
    CHECK_FALSE(fs::exists(temporary.path() / "grade"));
}

TEST_CASE("the grader of a kit from another kind of machine comes along, unless it is of another assignment") {
    const Assignment assignment = read_assignment("assignment.toml");
    const TemporaryFolder temporary;
    const fs::path other = temporary.path() / "other", both = temporary.path() / "both";
    hand_out(".", assignment, built_kit(), other);
    fs::rename(other / "grader" / kind_of_machine(), other / "grader/m68k-linux");
    hand_out(".", assignment, built_kit(), both, {other});
    CHECK(fs::exists(both / "grader/m68k-linux/toolchain.toml"));
    CHECK(fs::exists(both / "grader" / kind_of_machine() / "toolchain.toml"));

    std::ofstream(other / "assignment.toml", std::ios::app) << "# of last year\n";
    CHECK_THROWS_WITH(
        hand_out(".", assignment, built_kit(), temporary.path() / "mixed", {other}),
        other.string() + ": its assignment.toml is another one; expected a hand-out of this very project");
    // half a kit would stand in the way of the next call
    for (const char* left : {"mixed", "mixed.part"}) CHECK_FALSE(fs::exists(temporary.path() / left));
}
