#include <fmt/format.h>

#include <algorithm>

#include "catch.h"
#include "diagnosis/sanitizer.h"
#include "files/files.h"
#include "programs/compile.h"
#include "programs/object.h"
#include "programs/runner.h"
#include "protocol/rows.h"
#include "sandboxes.h"

using namespace grade;
using Catch::Matchers::ContainsSubstring;

namespace {

const Toolchain& chain() {
    static const Toolchain toolchain = read_toolchain(GRADE_TOOLCHAIN);
    return toolchain;
}

const std::string phong = read_text("solution/phong.cpp").value_or("");

Compiled compiled(const Sandbox& sandbox, const std::string& text) {
    return compile_fragment(chain(), sandbox, "phong", text, "phong.cpp", StepFolder().folder);
}

/// A program with this object of a fragment, and the solution's others.
fs::path linked(const Toolchain& chain, const Sandbox& sandbox, const std::string& fragment, const fs::path& object,
                const StepFolder& place) {
    std::vector<fs::path> objects{object};
    for (const auto& [name, others] : chain.solution_objects)
        if (name != fragment) objects.push_back(others);
    const fs::path program = place.outer.path() / "program/child";
    fs::create_directory(program.parent_path());
    CHECK(link_child(chain, sandbox, objects, program).empty());
    return program;
}

}  // namespace

TEST_CASE("a fragment compiles and links in every sandbox", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        const Compiled result = compile_fragment(chain(), sandbox, "phong", phong, "phong.cpp", place.folder);
        REQUIRE(result.message.empty());
        CHECK(fs::exists(linked(chain(), sandbox, "phong", result.object, place)));
        // what the precompiled header leaves out is there all the same
        CHECK(compiled(sandbox, phong + "double eighth = std::beta(2.0, 3.0) * 1.5;\n").message.empty());
    }
}

TEST_CASE("a fragment can include the framework's headers, and none of the assignment's other files", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        CHECK(compiled(sandbox, "#include \"rt/sampler.h\"\n" + phong).good);
        for (const std::string other : {"fragments/phong.cpp", "raytrace.cpp", "../solution/phong.cpp"}) {
            const Compiled result = compiled(sandbox, fmt::format("#include \"{}\"\n{}", other, phong));
            INFO(other << "\n" << result.message);
            CHECK_THAT(result.message, ContainsSubstring("fatal error: ") && ContainsSubstring(other));
        }
    }
}

TEST_CASE("a source whose compilation is slow is given up after the seconds that it may take", "[steps]") {
    std::string slow = phong;
    for (int i = 0; i < 400; ++i)
        slow += fmt::format(
            "void sorted{}(std::vector<double>& v) {{ std::sort(v.begin(), v.end(), [](auto a, auto b) {{ return a > "
            "b; "
            "}}); }}\n",
            i);
    const Sandbox sandbox = sandboxes().front();
    const Compiled result = compile_fragment(chain(), sandbox, "phong", slow, "phong.cpp", StepFolder().folder, 1);
    CHECK(result.message == "phong.cpp: error: the compiler ran longer than 1 s on it");
}

TEST_CASE("the compiler's warnings about the student's own file are kept, a few lines of them", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        CHECK(compiled(sandbox, phong).warnings.empty());
        const std::string unused = "static void f() { int a, b, c, d; }\n";
        const std::string warnings = compiled(sandbox, phong + unused).warnings;
        CHECK(warnings.starts_with("phong.cpp:"));
        CHECK(std::ranges::count(warnings, '\n') == 4);
        CHECK(warnings.find("and 2 more") != std::string::npos);
        // an error behind more warnings than are kept
        std::string many;
        for (int i = 0; i < 2000; ++i) many += fmt::format("static void unused_function_{}() {{ int unused; }}\n", i);
        CHECK(compiled(sandbox, many + phong + "int x = nothing;\n").message.find("nothing") != std::string::npos);
    }
}

TEST_CASE("of what does not compile, the missing header is told, and each error before the compiler's candidates") {
    const Sandbox sandbox = sandboxes().front();
    const auto said = [&](const std::string& body) {
        return compiled(sandbox,
                        "#include \"rt/fragments.h\"\nnamespace rt {\nColor phong(const Hit&, vec3, vec3 n) {\n" +
                            body + "\n}\n}\n")
            .message;
    };
    CHECK_THAT(said("std::cout << n.x;\nreturn Color(0);"),
               ContainsSubstring("phong.cpp:4") && ContainsSubstring("did you forget to ‘#include <iostream>’?"));
    const std::string print = said("std::printf(\"%g\", n.x);\nreturn Color(0);");
    CHECK_THAT(print, ContainsSubstring("did you forget to ‘#include <cstdio>’?") && !ContainsSubstring("‘rintf’"));
    const std::string two = said("const vec3 twice = 2 * n;\nreturn nothing;");
    CHECK_THAT(two, ContainsSubstring("phong.cpp:4") && ContainsSubstring("phong.cpp:5") &&
                        ContainsSubstring("nothing") && !ContainsSubstring("from ") && !ContainsSubstring("candidate"));
}

TEST_CASE("sanitizers say in which line a fragment breaks down", "[steps]") {
    const auto said = [](const Sandbox& sandbox, const std::string& body) {
        const StepFolder place;
        const Toolchain checked = with_sanitizers(chain());
        const Compiled result = compile_fragment(checked, sandbox, "moved",
                                                 "#include \"rt/fragments.h\"\n#include <vector>\nnamespace rt {\nvec3 "
                                                 "moved(vec3 point, vec3 velocity, Real time) {\n" +
                                                     body + "\n}\n}\n",
                                                 "moved.cpp", place.folder);
        REQUIRE(result.message.empty());
        Runner runner(linked(checked, sandbox, "moved", result.object, place), sandbox, fs::absolute("scenes"), 5,
                      true);
        const auto outcome = runner.probe("moved", {row(rt::vec3(1), rt::vec3(2), 3.0)});
        const Fault* fault = std::get_if<Fault>(&outcome);
        return fault ? fault_in_words(fault->excerpt, "moved") : "answered";
    };
    for (const Sandbox& sandbox : sandboxes()) {
        if (sandbox.kind == Sandbox::Kind::container) continue;
        INFO(sandbox.description);
        CHECK(said(sandbox, "return point + velocity * time;") == "answered");
        CHECK(said(sandbox, "if (time < 0) return point;").starts_with("moved.cpp:4: a way through this function"));
        CHECK(said(sandbox, "Real a[3] = {}; volatile int k = 5;\nreturn point * a[k];")
                  .starts_with("moved.cpp:6: index 5"));
        CHECK(said(sandbox, "return velocity + moved(velocity, point, time + 1);")
                  .ends_with(": the function calls itself without end"));
        CHECK(said(sandbox, "std::vector<Real> a(3);\nreturn point * a[std::size_t(time)];") ==
              "moved.cpp:6: an index is out of range");
    }
}

TEST_CASE("what a program that ends by itself has cost is counted as an answer is", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const StepFolder place;
        const Compiled result = compile_fragment(chain(), sandbox, "moved",
                                                 "#include \"rt/fragments.h\"\n#include <unistd.h>\nnamespace rt "
                                                 "{\nvec3 moved(vec3 point, vec3, Real time) {\n"
                                                 "if (time < 0) return point;\nusleep(1'200'000);\n_exit(0);\n}\n}\n",
                                                 "moved.cpp", place.folder);
        REQUIRE(result.message.empty());
        Runner runner(linked(chain(), sandbox, "moved", result.object, place), sandbox, fs::absolute("scenes"), 5);
        runner.begin_count();
        CHECK_FALSE(runner.has_answered());
        CHECK(std::holds_alternative<Rows>(runner.probe("moved", {row(rt::vec3(1), rt::vec3(2), -1.0)})));
        CHECK(runner.has_answered());
        CHECK(runner.seconds_in_all() < 1);
        const auto outcome = runner.probe("moved", {row(rt::vec3(1), rt::vec3(2), 3.0)});
        REQUIRE(std::holds_alternative<Fault>(outcome));
        CHECK(std::get<Fault>(outcome).verdict == Verdict::crashed);
        CHECK(runner.seconds_in_all() > 1);
    }
}

TEST_CASE("an object with sections that no compiler makes of a fragment goes no further", "[steps]") {
    std::vector<std::string> sections{".gnu.lto_.opts",  ".gnu.warning.x", ".interp", ".dynamic", ".preinit_array",
                                      ".gnu.debuglto_x", "penumbra",       ".init",   ".note.x"};
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        for (const std::string& section : sections) {
            const Compiled result = compiled(
                sandbox, fmt::format("asm(\".section {},\\\"a\\\"\\n.byte 1\\n.text\\n\");\n{}", section, phong));
            INFO(section);
            CHECK_FALSE(result.good);
            CHECK(result.message.find("a section " + section + " is made in it") != std::string::npos);
        }
        CHECK(compiled(sandbox,
                       "static struct A { A() { x = 1; } int x; ~A() { x = 2; } } a;\nthread_local int y = 3;\ninline "
                       "int z = 2;\n" +
                           phong)
                  .good);
        sections.resize(1);  // the other sandboxes see the same objects
    }
}

TEST_CASE("a function that would run while a program is loaded goes no further", "[steps]") {
    const std::string chooser =
        "extern \"C\" { static int one() { return 1; } static auto chosen() { return one; }\n"
        "static int other() __attribute__((ifunc(\"chosen\"))); }\nint use() { return other(); }\n";
    const Compiled result = compiled(sandboxes().front(), chooser + phong);
    INFO(result.message);
    CHECK_FALSE(result.good);
    CHECK_THAT(result.message, ContainsSubstring("(ifunc)"));
}

TEST_CASE("what cuts a compiler off is said in words, and is no fault of the compiler", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        for (const std::string file : {"/dev/stdout", "/dev/stdin", "/proc/self/fd/1", "/dev/zero"}) {
            const Compiled result = compiled(sandbox, "#include \"" + file + "\"\n" + phong);
            INFO(result.message);
            CHECK_FALSE(result.good);
            CHECK(result.message.find(file) != std::string::npos);
        }
        for (const auto& [text, words] :
             {std::pair<std::string, std::string>("char big[3000000000] = {1};\n",
                                                  "the compiler writes more than 32 MB for it"),
              {"asm(\".fill 1000000000, 8, 1\");\n", "the compiler"}}) {
            const Compiled result = compiled(sandbox, text + phong);
            INFO(result.message);
            CHECK_FALSE(result.good);
            CHECK(result.message.find("phong.cpp: error: " + words) != std::string::npos);
            CHECK(result.message.find("internal compiler error") == std::string::npos);
            CHECK(result.message.find("bug report") == std::string::npos);
        }
    }
}

TEST_CASE("symbols that explode when they are demangled cost the grader nothing", "[steps]") {
    // each of them is twice the one before in words, and a few characters in the object
    std::string text = "template <class A, class B> struct Pair {};\nusing T0 = Pair<int, int>;\n";
    for (int i = 1; i < 26; ++i) text += fmt::format("using T{} = Pair<T{}, T{}>;\n", i, i - 1, i - 1);
    text += "namespace rt { void phong(T25) {} }\n";
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Compiled result = compiled(sandbox, text);
        INFO(result.message.substr(0, 1000));
        CHECK_FALSE(result.good);
        CHECK(result.message.size() < 2000);
    }
}

TEST_CASE("tables of an object that lead out of it, or are cut off, are refused", "[steps]") {
    const std::string object = read_text(chain().solution_objects.at("phong")).value();
    CHECK(object_fault(read_object(object)).empty());
    CHECK(std::ranges::count(read_object(object).defined, chain().symbols.at("phong")) == 1);
    for (std::size_t size = 0; size < object.size(); size += 1 + size / 50)
        CHECK_THROWS_AS(read_object(object.substr(0, size)), BadObject);
    std::uint64_t random = 1;
    for (int trial = 0; trial < 20000; ++trial) {
        std::string changed = object;
        for (int i = 0; i < 4; ++i) {
            random = random * 6364136223846793005u + 1442695040888963407u;
            const std::size_t table = object.size() - std::min<std::size_t>(object.size(), 3000), at = random >> 33;
            changed[i % 2 ? at % 64 : table + at % (object.size() - table)] = char(random >> 56);
        }
        try {
            read_object(changed);
        } catch (const BadObject&) {}
    }
    CHECK_THROWS_AS(read_object("BC\xc0\xde and more of LLVM's own kind"), BadObject);
}
