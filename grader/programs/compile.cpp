#include "programs/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "programs/cache.h"
#include "files/files.h"
#include "programs/process.h"
#include "submission/source_fault.h"

namespace grade {

namespace {

constexpr int most_lines = 12;

/// The first errors of a compiler, with paths as the student knows them.
std::string first_errors(const std::string& output, const std::string& path, const std::string& shown) {
    std::istringstream lines(output);
    std::string text;
    int count = 0;
    bool relevant = false;
    for (std::string line; std::getline(lines, line) && count < most_lines;) {
        for (std::size_t at; (at = line.find(path)) != line.npos;) line.replace(at, path.size(), shown);
        const bool starts_note = line.find(": note:") != line.npos || line.find(": warning:") != line.npos;
        if (line.find("error:") != line.npos) relevant = true;
        else if (starts_note || line.find(": In ") != line.npos) relevant = false;
        if (!relevant) continue;
        if (line.size() > 300) line = line.substr(0, 300) + "...";
        text += line + "\n";
        ++count;
    }
    return text;
}

/// The largest file that compiler and linker may write.
constexpr std::uint64_t most_object_bytes = 32u << 20;

Limits compiler_limits() {
    Limits limits;
    limits.cpu_seconds = limits.most_cpu_seconds = 30;
    limits.wall_seconds = 600;  // on a busy machine a second of work takes many
    limits.memory = 3ull << 30;
    limits.file_size = most_object_bytes;
    return limits;
}

std::string why_not_built(const Ending& ending, const std::string& path, const std::string& shown) {
    if (ending.how == Ending::How::timed_out) return "the compiler ran longer than 30 s on it";
    if (ending.how == Ending::How::signalled) return "the compiler broke down on it: " + signal_in_words(ending.code);
    const std::string errors = first_errors(ending.err, path, shown);
    return errors.empty() ? fmt::format("the compiler failed:\n{}", ending.err.substr(0, 600)) : errors;
}

/// What the object defines under the fragment's name, and what fragments.h declares.
std::string wrong_signature(const Toolchain& chain, const fs::path& object, const std::string& fragment,
                            const std::string& shown) {
    std::string found;
    for (const std::string& symbol : symbols_of(object)) {
        const std::string name = demangled(symbol);
        if (name.find(fragment + "(") != name.npos) found = name;
    }
    const std::string expected = demangled(chain.symbols.at(fragment));
    if (found.empty())
        return fmt::format("{}: error: no function {} is defined here; fragments.h declares\n    {}\n", shown, fragment,
                           expected);
    return fmt::format("{}: error: the signature differs from fragments.h:\n    here         {}\n    fragments.h  {}\n",
                       shown, found, expected);
}

}  // namespace

Compiled compile_fragment(const Toolchain& chain, const Sandbox& sandbox, const std::string& fragment,
                          const std::string& text, const std::string& shown, const fs::path& work) {
    const fs::path source = work / (fragment + ".cpp"), object = work / "compiled.o";
    write_text(source, text);

    std::vector<std::string> command{chain.compiler.string()};
    command.insert(command.end(), chain.compile.begin(), chain.compile.end());
    command.insert(command.end(), {"-w", "-fdiagnostics-color=never", "-fno-lto"});
    std::vector<fs::path> readable = chain.includes;
    if (const fs::path header = precompiled_header(chain); !header.empty()) readable.insert(readable.begin(), header);
    for (const fs::path& folder : readable) command.insert(command.end(), {"-I", folder.string()});
    command.insert(command.end(), {"-c", source.string(), "-o", object.string()});

    const Ending compiler = run(inside(sandbox, command, readable, work), compiler_limits(), work.string());
    if (!compiler.good()) {
        require_room(work, most_object_bytes);  // else no fault of the submission
        const std::string fault = source_fault(text, shown);
        return {false, {}, fault.empty() ? why_not_built(compiler, source.string(), shown) : fault};
    }

    const auto symbol = chain.symbols.find(fragment);
    if (symbol == chain.symbols.end()) return {false, {}, "the framework calls no fragment of this name"};
    try {
        if (std::ranges::count(symbols_of(object), symbol->second) == 0)
            return {false, {}, wrong_signature(chain, object, fragment, shown)};
    } catch (const std::runtime_error&) {
        return {false, {}, shown + ": error: the object that the compiler makes of it cannot be read"};
    }

    // groups of sections that other objects hold as well must go before their symbols become private
    const fs::path merged = work / "merged.o", own = work / (fragment + ".o");
    Ending step =
        run(inside(sandbox, {"/usr/bin/ld", "-r", "--force-group-allocation", object.string(), "-o", merged.string()},
                   {}, work),
            compiler_limits(), work.string());
    if (step.good())
        step = run(inside(sandbox,
                          {"/usr/bin/objcopy", "--keep-global-symbol=" + symbol->second, "--remove-section=.gnu.lto_*",
                           "--remove-section=.gnu.debuglto_*", merged.string(), own.string()},
                          {}, work),
                   compiler_limits(), work.string());
    if (!step.good()) {
        require_room(work, most_object_bytes);
        return {false, {}, fmt::format("the object cannot be prepared for the link: {}", step.err.substr(0, 300))};
    }
    return {true, own, {}};
}

std::string link_child(const Toolchain& chain, const std::vector<fs::path>& objects, const fs::path& program) {
    std::vector<std::string> command{chain.compiler.string()};
    command.insert(command.end(), chain.link.begin(), chain.link.end());
    command.push_back("-fno-lto");  // no compiler runs on what a fragment may hold
    for (const fs::path& object : objects) command.push_back(object.string());
    for (const fs::path& archive : chain.archives) command.push_back(archive.string());
    command.insert(command.end(), chain.libraries.begin(), chain.libraries.end());
    command.insert(command.end(), {"-o", program.string()});

    const Ending linker = run(command, compiler_limits(), program.parent_path().string());
    if (linker.good()) return {};
    require_room(program.parent_path(), most_object_bytes);

    std::istringstream lines(linker.err);
    std::string text;
    int count = 0;
    for (std::string line; std::getline(lines, line) && count < 4;)
        if (const std::size_t at = line.find("undefined reference"); at != line.npos) {
            text += "error: " + line.substr(at) + ": it is declared and called, but defined nowhere in this file\n";
            ++count;
        }
    return text.empty() ? fmt::format("the link failed:\n{}", linker.err.substr(0, 600)) : text;
}

}  // namespace grade
