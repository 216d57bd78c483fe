#include "build/hand_out.h"

#include <fstream>
#include <map>

#include "assignment.h"
#include "build/files.h"
#include "build/strip.h"
#include "catch.h"

using namespace grade;

namespace {

std::string text_of(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::string trimmed(const std::string& line) {
    const auto first = line.find_first_not_of(" \t");
    return first == line.npos ? "" : line.substr(first);
}

}  // namespace

TEST_CASE("students get the project with fresh blanks, and no line of the solution's code") {
    const Assignment assignment = read_assignment("assignment.toml");
    const TemporaryFolder temporary;
    const fs::path folder = temporary.path() / "handed_out";
    hand_out(".", assignment, folder);

    for (const char* there :
         {"grade", ".ci/prepare.sh", "handout.md", "scenes/whitted.toml", "starter/rt/math.h", "grader/build/strip.h"})
        CHECK(fs::is_regular_file(folder / there));
    for (const char* not_there : {"solution", "tests", "build", ".git"}) CHECK_FALSE(fs::exists(folder / not_there));
    std::map<std::string, std::string> origin;  // of each line that a student must write
    for (const Fragment& fragment : assignment.fragments) {
        const std::string file = fragment.name + ".cpp", solution = "solution/" + file;
        INFO(fragment.name);
        CHECK(text_of(folder / "starter/fragments" / file) == text_of(folder / "grader/blanks" / file));
        if (fragment.given) continue;
        CHECK(text_of(folder / "grader/blanks" / file).find("not_started(") != std::string::npos);
        for (const auto& line : secrets(find_region(text_of(solution), solution))) origin[line] = solution;
    }
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string extension = entry.path().extension().string();
        if (extension != ".cpp" && extension != ".h" && extension != ".md") continue;
        std::ifstream in(entry.path());
        int number = 0;
        for (std::string line; std::getline(in, line);) {
            ++number;
            const auto secret = origin.find(trimmed(line));
            INFO(entry.path() << ":" << number << ": " << line);
            CHECK(secret == origin.end());
        }
    }
}

TEST_CASE("nothing is handed out into a folder that holds something") {
    const TemporaryFolder temporary;
    std::ofstream(temporary.path() / "mine.txt") << "do not touch";
    CHECK_THROWS_WITH(hand_out(".", read_assignment("assignment.toml"), temporary.path()),
                      temporary.path().string() + ": is not empty; expected a new folder");
    CHECK_FALSE(fs::exists(temporary.path() / "grade"));
}
