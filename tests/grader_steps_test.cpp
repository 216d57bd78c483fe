#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <iterator>

#include "catch.h"
#include "diagnosis/sanitizer.h"
#include "files/files.h"
#include "programs/compile.h"
#include "programs/object.h"
#include "programs/runner.h"
#include "programs/sandbox.h"
#include "protocol/rows.h"

using namespace grade;

namespace {

/// Whether other users reach what is in a folder: what a step of another user compiles with is there.
bool is_open_to_others(fs::path folder) {
    for (; folder != folder.root_path(); folder = folder.parent_path())
        if ((fs::status(folder).permissions() & fs::perms::others_exec) == fs::perms::none) return false;
    return true;
}

/// Every kind of sandbox that works on this machine.
std::vector<Sandbox> sandboxes() {
    std::vector<Sandbox> all;
    for (const auto& [kind, own_user] :
         {std::pair(Sandbox::Kind::host, false), {Sandbox::Kind::container, true}, {Sandbox::Kind::container, false}}) {
        Sandbox sandbox{kind, {}, {}, own_user};
        if (own_user && (geteuid() != 0 || !is_open_to_others(fs::current_path()))) continue;
        const std::string fault = fault_of(sandbox, {});
        sandbox.description = fmt::format("kind {}, a user of its own: {}", int(kind), own_user);
        if (fault.empty())
            all.push_back(sandbox);
        else
            WARN(sandbox.description << " does not work here: " << fault);
    }
    return all;
}

/// A folder that a step of any user may start in.
struct Place {
    Place() {
        fs::permissions(outer.path(), fs::perms(0711));
        fs::create_directory(folder);
    }
    TemporaryFolder outer;
    fs::path folder = outer.path() / "step";
};

Ending shell(const Sandbox& sandbox, const fs::path& folder, const std::string& text, bool is_tool = true,
             double wall = 20) {
    Step step{{"/bin/sh", "-c", text}, {}, folder, {}, is_tool};
    step.limits.wall_seconds = wall;
    return run(sandbox, step);
}

int count_of(const std::string& word) {
    int count = 0;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        std::ifstream line(entry.path() / "cmdline");
        count += std::string(std::istreambuf_iterator<char>(line), {}).find(word) != std::string::npos;
    }
    return count;
}

const Toolchain& chain() {
    static const Toolchain toolchain = read_toolchain(GRADE_TOOLCHAIN);
    return toolchain;
}

const std::string phong = read_text("solution/phong.cpp").value_or("");

Compiled compiled(const Sandbox& sandbox, const std::string& text) {
    return compile_fragment(chain(), sandbox, "phong", text, "phong.cpp", Place().folder);
}

/// A program with this object of a fragment, and the solution's others.
fs::path linked(const Toolchain& chain, const Sandbox& sandbox, const std::string& fragment, const fs::path& object,
                const Place& place) {
    std::vector<fs::path> objects{object};
    for (const auto& [name, others] : chain.solution_objects)
        if (name != fragment) objects.push_back(others);
    const fs::path program = place.outer.path() / "program/child";
    fs::create_directory(program.parent_path());
    CHECK(link_child(chain, sandbox, objects, program).empty());
    return program;
}

}  // namespace

TEST_CASE("a step sees its own folder, and neither another nor a secret, nor the environment", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Place place, other;
        write_text(other.folder / "secret", "secret");
        write_text(place.folder / "mine", "mine");
        setenv("PENUMBRA_SECRET", "secret", 1);
        CHECK(shell(sandbox, place.folder, "cat mine").out == "mine");
        CHECK(shell(sandbox, place.folder, "cat " + (other.folder / "secret").string()).out.empty());
        CHECK(shell(sandbox, place.folder, "cat solution/phong.cpp " + fs::absolute("solution/phong.cpp").string())
                  .out.empty());
        CHECK(shell(sandbox, place.folder, "cat /etc/passwd /proc/1/environ /proc/self/maps").out.empty());
        CHECK(shell(sandbox, place.folder, "env").out.find("secret") == std::string::npos);
        CHECK(shell(sandbox, place.folder,
                    fmt::format("kill -9 {} && echo sent; kill -9 $PPID && echo sent; true", getpid()))
                  .out.empty());
        shell(sandbox, place.folder,
              "echo x >" + (other.folder / "new").string() + "; echo x >/dev/shm/penumbra; echo x >/x");
        CHECK_FALSE(fs::exists(other.folder / "new"));
        CHECK_FALSE(fs::exists("/dev/shm/penumbra"));
        CHECK_FALSE(fs::exists("/x"));
    }
}

TEST_CASE("a tool writes into its folder, and nothing that it starts outlives it", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Place place;
        CHECK(
            shell(sandbox, place.folder, "echo made >made && mkdir -p deep && mv made deep/made && chmod 700 deep/made")
                .good());
        CHECK(read_text(place.folder / "deep/made") == "made\n");
        const std::string seconds = fmt::format("{}.5", 700000 + getpid());
        for (const std::string start : {"sleep ", "setsid sleep ", "nohup sleep "})
            shell(sandbox, place.folder, start + seconds + " & " + start + seconds + " & exit 0");
        CHECK(count_of(seconds) == 0);
        CHECK(shell(sandbox, place.folder, "sleep " + seconds, true, 0.5).waited);
        CHECK(count_of(seconds) == 0);
    }
}

TEST_CASE("a student's program starts no other, and writes nowhere", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Place place;
        write_text(place.folder / "there", "there");
        CHECK(shell(sandbox, place.folder, "echo only this", false).out == "only this\n");
        const Ending forks = shell(sandbox, place.folder, "/bin/true; echo more", false);
        CHECK(forks.how == Ending::How::signalled);
        CHECK(forks.code == SIGSYS);
        CHECK(forks.out.empty());
        shell(sandbox, place.folder, "echo x >new", false);
        shell(sandbox, place.folder, "echo x >>there", false);
        shell(sandbox, place.folder, "echo x >there", false);
        CHECK_FALSE(fs::exists(place.folder / "new"));
        CHECK(read_text(place.folder / "there") == "there");
        for (const std::string own : {"chmod 000 there", "truncate -s 0 there", "touch -d 2000-01-01 there"})
            CHECK_FALSE(shell(sandbox, place.folder, "exec " + own, false).good());
        CHECK(read_text(place.folder / "there") == "there");
    }
}

TEST_CASE("nothing can be read again from where a step writes to", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Place place;
        for (const std::string file : {"/dev/stdout", "/dev/stdin", "/dev/zero", "/dev/tty", "/proc/self/fd/1",
                                       "/proc/self/fd/0", "/dev/fd/2"}) {
            const Ending ending = shell(sandbox, place.folder, "exec cat " + file);
            INFO(file);
            CHECK(ending.how == Ending::How::exited);
            CHECK(ending.code == 1);
        }
        CHECK(shell(sandbox, place.folder, "cat; echo end").out == "end\n");
    }
}

TEST_CASE("a sandbox that does not work is told, and the grader goes no further", "[steps]") {
    CHECK_FALSE(fault_of({Sandbox::Kind::host, {}, {}}, {"/no/such/file"}).empty());
    CHECK_THROWS_WITH(find_sandbox(false, {"/no/such/file"}),
                      Catch::Matchers::ContainsSubstring("there is no sandbox here") &&
                          Catch::Matchers::ContainsSubstring("--trusted"));
    CHECK(find_sandbox(true, {"/no/such/file"}).kind == Sandbox::Kind::limits_only);
}

TEST_CASE("a fragment compiles and links in every sandbox", "[steps]") {
    for (const Sandbox& sandbox : sandboxes()) {
        INFO(sandbox.description);
        const Place place;
        const Compiled result = compile_fragment(chain(), sandbox, "phong", phong, "phong.cpp", place.folder);
        REQUIRE(result.message.empty());
        CHECK(fs::exists(linked(chain(), sandbox, "phong", result.object, place)));
        // what the precompiled header leaves out is there all the same
        CHECK(compiled(sandbox, phong + "double eighth = std::beta(2.0, 3.0) * 1.5;\n").message.empty());
    }
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

TEST_CASE("sanitizers say in which line a fragment breaks down", "[steps]") {
    const auto said = [](const Sandbox& sandbox, const std::string& body) {
        const Place place;
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

TEST_CASE("only the runner of steps starts processes", "[steps]") {
    const std::vector<std::string> ways{"fork(", "vfork(",      "clone(", "execv",
                                        "execl", "posix_spawn", "popen(", "system("};
    std::vector<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator("grader")) {
        if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
        const std::string text = read_text(entry.path()).value_or("");
        for (const std::string& way : ways)
            for (std::size_t at = 0; (at = text.find(way, at)) != text.npos; ++at)
                if (at == 0 || (std::isalnum(text[at - 1]) == 0 && text[at - 1] != '_'))
                    found.push_back(entry.path().generic_string() + ": " + way);
    }
    std::ranges::sort(found);
    // the first is the user's own code in view, the third becomes grade_studies, with the words that it was called with
    CHECK(found == std::vector<std::string>{"grader/commands/call.cpp: execv", "grader/commands/call.cpp: fork(",
                                            "grader/commands/command_line.cpp: execv",
                                            "grader/programs/process.cpp: execv",
                                            "grader/programs/process.cpp: fork("});
}
