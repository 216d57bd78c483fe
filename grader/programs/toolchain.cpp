#include "programs/toolchain.h"

#include <cxxabi.h>
#include <fmt/format.h>
#include <toml++/toml.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <sstream>
#include <stdexcept>

#include "arithmetic/self_test.h"
#include "files/files.h"
#include "programs/process.h"
#include "rt/processor.h"

namespace grade {

namespace {

std::vector<std::string> list(const toml::table& file, const char* key) {
    std::vector<std::string> values;
    if (const toml::array* array = file[key].as_array())
        for (const toml::node& node : *array)
            if (std::string value = node.value_or(std::string()); !value.empty()) values.push_back(std::move(value));
    return values;
}

/// By fragment: .../phong.cpp.o is phong's.
std::map<std::string, fs::path> by_fragment(const std::vector<fs::path>& objects) {
    std::map<std::string, fs::path> map;
    for (const fs::path& object : objects) {
        const std::string file = object.filename().string();
        map[file.substr(0, file.find('.'))] = object;
    }
    return map;
}

/// "rt::phong(rt::Material const&, ...)" for a linker's name; the name itself where it is not one of C++.
std::string demangled(const std::string& symbol) {
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(abi::__cxa_demangle(symbol.c_str(), nullptr, nullptr, &status),
                                                      std::free);
    return status == 0 ? name.get() : symbol;
}

/// The fragments' names for the linker, from what the child needs: rt::phong(...) is phong's.
std::map<std::string, std::string> fragment_symbols(const fs::path& child) {
    Limits limits;
    limits.output = 8u << 20;
    const Ending nm =
        run({"/usr/bin/nm", "--format=posix", "--undefined-only", "--extern-only", child.string()}, limits, "/");
    if (!nm.good()) throw std::runtime_error(fmt::format("{}: nm cannot read it: {}", child.string(), nm.err));
    std::map<std::string, std::string> map;
    std::istringstream lines(nm.out);
    for (std::string line; std::getline(lines, line);) {
        const std::string symbol = line.substr(0, line.find(' ')), name = demangled(symbol);
        const std::size_t bracket = name.find('(');
        if (name.starts_with("rt::") && bracket != name.npos) map[name.substr(4, bracket - 4)] = symbol;
    }
    return map;
}

/// Throws where a child could not be made or started here: else that would look like a mistake in a fragment.
void check_machine(const Toolchain& chain) {
    if (!rt::processor_is(chain.processor.c_str()))
        throw std::runtime_error(
            fmt::format("what fragments are linked with is built for {} processors, and this one is none; "
                        "expected a build on this machine, or with -DRT_MARCH=x86-64-v2",
                        chain.processor));
    if (access(chain.compiler.c_str(), X_OK) != 0)
        throw std::runtime_error(fmt::format("{}: the compiler of the build is not there; expected it, or a new build",
                                             chain.compiler.string()));
    for (const fs::path& archive : chain.archives)
        if (!fs::exists(archive)) throw std::runtime_error(fmt::format("{}: not built yet", archive.string()));
    if (const fs::path header = chain.includes.front() / "rt/fragments.h"; !fs::exists(header))
        throw std::runtime_error(
            fmt::format("{}: not there; expected the folder that was built, or a new build", header.string()));
}

/// The compiler of this machine, as a shell finds it.
fs::path find_compiler() {
    const char* chosen = std::getenv("CXX");
    const char* path = std::getenv("PATH");
    for (const std::string name : {chosen ? chosen : "", "g++", "c++", "clang++"}) {
        if (name.find('/') != name.npos && access(name.c_str(), X_OK) == 0) return name;
        std::istringstream folders(path ? path : "/usr/bin:/bin");
        for (std::string folder; !name.empty() && std::getline(folders, folder, ':');)
            if (const fs::path program = fs::path(folder) / name; access(program.c_str(), X_OK) == 0) return program;
    }
    throw std::runtime_error("there is no C++ compiler here; expected g++ or clang++: as root, apt-get install g++");
}

std::string first_line(const fs::path& compiler) {
    const Ending said = run({compiler.string(), "--version"}, Limits{}, "/");
    return said.out.substr(0, said.out.find('\n'));
}

bool defines_no_clang(const fs::path& compiler) {
    const Ending said = run({compiler.string(), "-dM", "-E", "-x", "c++", "/dev/null"}, Limits{}, "/");
    return said.good() && said.out.find("#define __clang__ ") == said.out.npos;
}

/// The option for a linker that needs half of the usual one's time. Empty: there is none.
std::string fast_linker() {
    if (fs::exists("/usr/bin/ld.gold")) return "-fuse-ld=gold";
    return fs::exists("/usr/libexec/mold/ld") ? "-B/usr/libexec/mold" : "";  // not all compilers know it by its name
}

/// The option among these that changes arithmetic; empty: none.
std::string changing_option(const Toolchain& chain) {
    std::string contraction = "the missing -ffp-contract=off", fast;
    for (const auto* list : {&chain.compile, &chain.link})
        for (const std::string& option : *list) {
            if (option.starts_with("-ffp-contract=")) contraction = option == "-ffp-contract=off" ? "" : option;
            for (const char* other : {"-ffast-math", "-Ofast", "-funsafe-math-optimizations", "-ffinite-math-only",
                                      "-fassociative-math", "-freciprocal-math"})
                if (option == other) fast = option;
        }
    return fast.empty() ? contraction : fast;
}

/// Throws std::runtime_error where this program, or how fragments are compiled, does not compute as IEEE 754 has it:
/// its verdicts could not be defended.
void refuse_other_arithmetic(const Toolchain& chain) {
    if (const std::string fault = arithmetic_fault(); !fault.empty())
        throw std::runtime_error(fmt::format(
            "it refuses to grade, since its own arithmetic is not exact: {}; expected plain IEEE 754", fault));
    if (const std::string option = changing_option(chain); !option.empty())
        throw std::runtime_error(
            fmt::format("it refuses to grade, since {} changes the arithmetic of fragments; expected -ffp-contract=off "
                        "and no fast-math",
                        option));
}

}  // namespace

bool Toolchain::is_given(const fs::path& object) const {
    const auto is_it = [&](const auto& entry) { return entry.second == object; };
    return std::ranges::any_of(solution_objects, is_it) || std::ranges::any_of(blank_objects, is_it);
}

std::vector<fs::path> Toolchain::own_folders() const {
    if (cache.empty()) return {source};
    return {source, cache};
}

bool Toolchain::is_own(const fs::path& file) const {
    return std::ranges::any_of(own_folders(), [&](const fs::path& own) {
        const fs::path within = file.lexically_relative(own);
        return !within.empty() && *within.begin() != "..";
    });
}

Toolchain with_sanitizers(const Toolchain& chain) {
    Toolchain checked = chain;
    checked.checked = true;
    checked.compile.insert(checked.compile.end(),
                           {"-g1", "-O1", "-fno-omit-frame-pointer", "-fsanitize=address,undefined",
                            "-fno-sanitize-recover=all", "-D_GLIBCXX_ASSERTIONS", "-ftrivial-auto-var-init=pattern"});
    checked.link.emplace_back("-fsanitize=address,undefined");
    return checked;
}

std::vector<std::string> all_fragments(const Toolchain& chain, const Assignment& assignment) {
    std::vector<std::string> names = assignment.names();
    for (const auto& [name, object] : chain.solution_objects)
        if (std::ranges::count(names, name) == 0) names.push_back(name);
    return names;
}

Toolchain read_toolchain(const fs::path& path) try {
    const toml::table file = toml::parse_file(path.string());
    const fs::path folder = fs::absolute(path).parent_path();
    const auto text = [&](const char* key) { return file[key].value_or(std::string()); };
    const auto place = [&](const std::string& name) { return (folder / name).lexically_normal(); };
    const auto places = [&](const char* key) {
        std::vector<fs::path> all;
        for (const std::string& name : list(file, key))
            if (name != "/usr/include") all.push_back(place(name));
        return all;
    };

    Toolchain chain;
    chain.source = place(text("source"));
    chain.processor = text("processor");
    chain.is_kit = file["kit"].value_or(false);
    chain.compiler = text("compiler").empty() ? find_compiler() : fs::path(text("compiler"));
    chain.description = text("description").empty() ? first_line(chain.compiler) : text("description");
    chain.is_gcc = file["gcc"].value_or(false) || (!file.contains("gcc") && defines_no_clang(chain.compiler));
    chain.commit = text("commit");
    chain.compile = list(file, "compile");
    for (const std::string& option : list(file, "options")) chain.compile.push_back(option);
    chain.includes = places("includes");
    if (const std::string cache = text("cache"); !cache.empty()) chain.cache = place(cache);
    chain.link = list(file, "link");
    if (const std::string option = fast_linker(); !option.empty()) chain.link.push_back(option);
    chain.archives = places("archives");
    chain.libraries = list(file, "libraries");
    for (const fs::path& library : places("kit_libraries")) chain.libraries.push_back(library.string());
    if (chain.is_kit)
        for (const std::string& word : {std::string("-rpath"), place("lib").string()})
            chain.libraries.insert(chain.libraries.end(), {"-Xlinker", word});
    chain.blanks = place(text("blanks"));
    chain.blank_objects = by_fragment(places("blank_objects"));
    chain.solution_objects = by_fragment(places("solution_objects"));
    if (chain.archives.empty() || chain.includes.empty())
        throw std::runtime_error(fmt::format("{}: names no archives or no headers", path.string()));
    check_machine(chain);
    chain.symbols = fragment_symbols(chain.archives.front());
    refuse_other_arithmetic(chain);
    return chain;
} catch (const toml::parse_error& error) {
    throw std::runtime_error(
        fmt::format("{}: {}; expected the file that the build writes", path.string(), error.description()));
}

Assignment assignment_of(const Toolchain& chain) {
    // a kit has no sources; an author's may be newer than the build
    std::vector<std::string> known = fragments_in((chain.source / "solution").string());
    for (const auto& [name, object] : chain.solution_objects) known.push_back(name);
    return read_assignment((chain.source / "assignment.toml").string(), known);
}

fs::path own_toolchain() {
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error), here = program.parent_path();
    const fs::path beside = here / "toolchain.toml", built = here.parent_path() / "toolchain.toml";
    if (fs::exists(beside, error)) return beside;
    if (!fs::exists(built, error))
        throw std::runtime_error(fmt::format("{}: not there; expected {} in the folder where it was built",
                                             built.string(), program.filename().string()));
    const fs::path home = toml::parse_file(built.string())["cache"].value_or(std::string());
    if (!fs::equivalent(home, here.parent_path(), error))
        throw std::runtime_error(fmt::format(
            "{}: was built as part of {} and has been moved or copied; expected a build of its own: ./grade makes it",
            here.parent_path().string(), home.string()));
    return built;
}

void tell_whose_assignment(const fs::path& toolchain) {
    std::error_code error;
    const fs::path source =
        (fs::absolute(toolchain).parent_path() / toml::parse_file(toolchain.string())["source"].value_or(std::string()))
            .lexically_normal();
    const auto own = read_text(source / "assignment.toml");
    for (fs::path folder = fs::current_path(error); !error; folder = folder.parent_path()) {
        if (const auto here = read_text(folder / "assignment.toml")) {
            if (own != here)
                fmt::print(
                    stderr,
                    "this grader is of {}, and its assignment counts; {} is another one: for that, its own grader\n",
                    source.string(), (folder / "assignment.toml").string());
            return;
        }
        if (folder == folder.root_path()) return;
    }
}

}  // namespace grade
