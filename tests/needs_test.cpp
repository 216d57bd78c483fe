#include <fmt/format.h>

#include <map>
#include <set>

#include "build/compile.h"
#include "build/files.h"
#include "build/process.h"
#include "build/runner.h"
#include "catch.h"
#include "checks/kit/check.h"
#include "judging/experiment.h"
#include "judging/mentions.h"

using namespace grade;

namespace {

using Names = std::set<std::string>;

/// A program with the solution's fragments of these names. Any other ends it as soon as it is called.
class Program {
public:
    Program(const Toolchain& chain, const Names& called) {
        std::string text = ".text\n";
        std::vector<fs::path> objects{folder_.path() / "ends.o"};
        for (const auto& [fragment, object] : chain.solution_objects) {
            if (called.contains(fragment)) {
                objects.push_back(object);
                continue;
            }
            others_.push_back(fragment);
            text += fmt::format(".globl {0}\n{0}:\n    mov ${1}, %edi\n    call _exit@PLT\n", chain.symbols.at(fragment),
                                others_.size());
        }
        const fs::path source = folder_.path() / "ends.s";
        write_text(source, text);
        const Ending assembler = run({chain.compiler.string(), "-c", source.string(), "-o", objects[0].string()}, {},
                                     folder_.path().string());
        INFO(assembler.err);
        REQUIRE(assembler.good());
        REQUIRE(link_child(chain, objects, folder_.path() / "child") == "");
    }

    /// The other fragment that a check calls first; empty: none. Whatever else is wrong is said as it is.
    std::string other_called(const Toolchain& chain, const Check& check) const {
        Runner runner(folder_.path() / "child", find_sandbox(true), chain.source / "scenes", 20);
        const auto outcome = observe(runner, check, 1);
        const Fault* fault = std::get_if<Fault>(&outcome);
        if (!fault) return "";
        int code = 0;
        const bool ended = std::sscanf(fault->message.c_str(), "the program ended by itself with code %d", &code) == 1;
        return ended ? others_.at(std::size_t(code) - 1) : fault->message;
    }

private:
    TemporaryFolder folder_;
    std::vector<std::string> others_;
};

}  // namespace

TEST_CASE("a check calls its own fragment, those that it says it needs, and those that these name, no other") {
    const Toolchain chain = read_toolchain(GRADE_TOOLCHAIN);
    Names all;
    for (const auto& [fragment, object] : chain.solution_objects) all.insert(fragment);
    const auto solution = [&](const std::string& fragment) { return read_text(chain.source / "solution" / (fragment + ".cpp")).value(); };
    std::map<Names, std::vector<Check>> by_fragments;
    for (const std::uint64_t seed : {1, 2})
        for (const Check& check : all_checks(seed)) {
            Names called(check.needs.begin(), check.needs.end());
            called.insert(check.fragment);
            by_fragments[with_mentioned(called, all, solution)].push_back(check);
        }
    for (const auto& [called, checks] : by_fragments) {
        const Program program(chain, called);
        for (const Check& check : checks) {
            CAPTURE(key_of(check));
            CHECK(program.other_called(chain, check) == "");
        }
    }
}

TEST_CASE("fragments are named by whole words, and what they name names others") {
    const std::map<std::string, std::string> texts{
        {"a", "int a() { return b(); }"}, {"b", "// see c"}, {"c", "aa + dd, d_ and 2d"}, {"d", "a"}, {"e", "d"}};
    const auto text = [&](const std::string& name) { return texts.at(name); };
    const Names all{"a", "b", "c", "d", "e"};
    CHECK(with_mentioned({"a"}, all, text) == Names{"a", "b", "c"});
    CHECK(with_mentioned({"e"}, all, text) == all);
    CHECK(with_mentioned({"c"}, all, text) == Names{"c"});
}

TEST_CASE("a fragment that a check calls without saying so is found") {
    const Toolchain chain = read_toolchain(GRADE_TOOLCHAIN);
    Names called;
    for (const auto& [fragment, object] : chain.solution_objects)
        if (fragment != "camera_ray") called.insert(fragment);
    const Program program(chain, called);
    for (const Check& check : all_checks(1)) {
        if (!std::holds_alternative<Render>(check.experiment)) continue;
        CHECK(program.other_called(chain, check) == "camera_ray");
        break;
    }
}
