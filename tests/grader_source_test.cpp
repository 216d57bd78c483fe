#include "catch.h"
#include "submission/code_only.h"
#include "submission/source_fault.h"

using namespace grade;

TEST_CASE("comments, white space, line ends and byte order marks are not code") {
    CHECK(code_only("a = 1; // one\n/* two\n*/ b") == "a=1;b");
    CHECK(code_only("\xef\xbb\xbf"
                    "a\r\n= b") == "a=b");
    CHECK(code_only("s = \"// a b\"; c = ' ';") == "s=\"// a b\";c=' ';");
    CHECK(code_only("1'000 // '\n+ 2") == "1'000+2");
    CHECK(code_only("\"\\\" // x\" y").size() == 10);
    CHECK(code_only("/* open") == "");
    CHECK(code_only("a b") != code_only("a c"));
}

TEST_CASE("what is no C++ at all is named in one sentence", "[submission]") {
    const auto fault = [](const std::string& text) { return source_fault(text, "f/moved.cpp"); };
    const std::string good =
        "#include \"rt/fragments.h\"\nnamespace rt {\nvec3 moved(vec3 p, vec3 v, Real t) { return p + t * v; }\n}\n";
    CHECK(fault(good) == "");
    CHECK(fault("\xef\xbb\xbf" + good) == "");
    CHECK(fault("const char* a = \"/*\"; char b = '\"'; // /* \nauto c = R\"x( /* \" )x\"; int d = 1'000; /* closed "
                "*/\n") == "");
    std::string wide = "\xff\xfe";
    for (const char c : good) wide += c, wide += '\0';
    CHECK(fault(wide) ==
          "f/moved.cpp:1:1: error: the file is UTF-16 text, which no compiler reads; expected UTF-8: save it again as "
          "such\n");
    CHECK(fault(wide.substr(2)).find("UTF-16") != std::string::npos);
    CHECK(fault(good + "/* the end") ==
          "f/moved.cpp:5:1: error: the comment that starts here has no end; expected */\n");
    CHECK(fault("int a; /* one\nint b;").starts_with("f/moved.cpp:1:8: "));
    CHECK(fault("a\n<<<<<<< HEAD\nb\n=======\nc\n>>>>>>> theirs\n")
              .starts_with("f/moved.cpp:2:1: error: a merge conflict is not resolved: git has left the line '<<<<<<< "
                           "HEAD'; expected one of"));
    CHECK(fault("<!DOCTYPE html>\n<html>").find("web page") != std::string::npos);
    CHECK(fault("{\\rtf1\\ansi").find("RTF") != std::string::npos);
    CHECK(fault("```cpp\n" + good + "```\n").find("Markdown") != std::string::npos);
    CHECK(fault(good + std::string("\0", 1)).find("a byte 0") != std::string::npos);
    // such a file is no blank, though no code is left of it
    CHECK_FALSE(is_blank("/* all of it\n" + good, "solution/moved.cpp"));
    CHECK(is_blank("/* all of it */\n", "solution/moved.cpp"));
}
