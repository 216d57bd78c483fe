#include "assignment/strip.h"

#include <fstream>
#include <map>
#include <sstream>

#include "catch.h"
#include "files/files.h"
#include "files/words.h"
#include "secrets.h"

using namespace grade;

namespace {

std::string error_of(const std::string& text) {
    return complaint_of([&] { find_region(text, "f.cpp"); });
}

}  // namespace

TEST_CASE("a region becomes the fallback, at the marker's indentation") {
    const Marked file = find_region("a\n    // BEGIN SOLUTION\n    b\n    // END SOLUTION: return 0;\nc\n", "f.cpp");
    CHECK(blank(file) == "a\n    // YOUR CODE HERE\n    return 0;\nc\n");
    CHECK(filled(file) == "a\n    b\nc\n");
}

TEST_CASE("markers that are missing, repeated or out of order are errors with their place") {
    const std::string begin = "  // BEGIN SOLUTION\n", end = "  // END SOLUTION: return 0;\n";
    CHECK(error_of(begin + end) == "");
    CHECK(error_of("a\nb\n").rfind("f.cpp:3:1: no BEGIN SOLUTION", 0) == 0);
    CHECK(error_of(begin + "a\n").rfind("f.cpp:3:1: the file ends inside", 0) == 0);
    CHECK(error_of("a\n" + end).rfind("f.cpp:2:3: END SOLUTION without", 0) == 0);
    CHECK(error_of(begin + begin + end).rfind("f.cpp:2:3: a second BEGIN", 0) == 0);
    CHECK(error_of(begin + end + begin + end).rfind("f.cpp:3:3: a second region", 0) == 0);
    CHECK(error_of(begin + end + end).rfind("f.cpp:3:3: a second END", 0) == 0);
    CHECK(error_of(begin + "  // END SOLUTION\n").rfind("f.cpp:2:18: no fallback", 0) == 0);
}

TEST_CASE("a fragment that is asked is blank, the others are filled in; drift names the first character that differs") {
    const fs::path folder = fs::temp_directory_path() / "penumbra_strip_test";
    fs::remove_all(folder);
    fs::create_directories(folder / "solution");
    for (const char* name : {"one", "two"})
        std::ofstream(folder / "solution" / (std::string(name) + ".cpp"))
            << "// BEGIN SOLUTION\n"
            << name << "();\n// END SOLUTION: return 0;\n";

    const auto files = make_starter((folder / "solution").string(), {"one"});
    CHECK(files.at("one.cpp") == "// YOUR CODE HERE\nreturn 0;\n");
    CHECK(files.at("two.cpp") == "two();\n");

    const std::string starter = (folder / "starter").string();
    write_starter(files, starter);
    CHECK(drift(files, starter).empty());
    std::ofstream(starter + "/two.cpp") << "twO();\n";
    std::ofstream(starter + "/three.cpp") << "";
    fs::remove(starter + "/one.cpp");
    const auto lines = drift(files, starter);
    REQUIRE(lines.size() == 3);
    CHECK(lines[0].find("three.cpp:1:1: no such fragment") != std::string::npos);
    CHECK(lines[1].find("one.cpp:1:1: missing") != std::string::npos);
    CHECK(lines[2].find("two.cpp:1:3: not what") != std::string::npos);
    fs::remove_all(folder);
}

TEST_CASE("the starter holds no line of what a student must write") {
    const std::map<std::string, std::string> origin = secrets();
    REQUIRE(origin.size() > 40);

    for (const auto& entry : fs::recursive_directory_iterator("starter")) {
        if (!entry.is_regular_file()) continue;
        std::istringstream text(read_text(entry.path()).value());
        int number = 0;
        for (std::string line; std::getline(text, line);) {
            ++number;
            const auto secret = origin.find(trimmed(line));
            INFO(entry.path().string() << ":" << number << ": " << line);
            if (secret != origin.end()) FAIL_CHECK("is a line of " << secret->second);
        }
    }
}
