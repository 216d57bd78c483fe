#include "programs/compile.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "files/files.h"
#include "programs/cache.h"
#include "programs/object.h"
#include "programs/wrong_signature.h"
#include "submission/source_fault.h"

namespace grade {

namespace {

constexpr int most_lines = 12;

/// The largest file that compiler and linker may write.
constexpr std::uint64_t most_object_bytes = 32u << 20;

constexpr double tool_seconds = most_compiler_seconds;

/// A step of the compiler and its kin in that folder.
Step tool(std::vector<std::string> command, const fs::path& folder, std::vector<fs::path> readable = {},
          double seconds = tool_seconds) {
    Step step{std::move(command), std::move(readable), folder, {}};
    step.limits.cpu_seconds = step.limits.most_cpu_seconds = seconds;
    step.limits.wall_seconds = 3 * tool_seconds;
    step.limits.memory = 3ull << 30;
    step.limits.file_size = most_object_bytes;
    return step;
}

/// The error of a function of <cstdio> that is not declared, with what to do; GCC proposes another name. Empty: none.
std::string missing_header(const std::string& line) {
    for (const char* name : {"printf", "fprintf", "puts", "putchar", "fflush"})
        if (const std::size_t at = line.find(fmt::format("‘{}’ is not a member of ‘std’; did you mean", name));
            at != line.npos)
            return line.substr(0, line.find("; did you mean", at)) + "; did you forget to ‘#include <cstdio>’?";
    return {};
}

/// The first errors of a compiler, with paths as the student knows them, and which header is missing.
std::string first_errors(const std::string& output, const std::string& path, const std::string& shown) {
    std::istringstream lines(output);
    std::string text;
    int count = 0;
    bool relevant = false;
    for (std::string line; std::getline(lines, line) && count < most_lines;) {
        for (std::size_t at = 0; (at = line.find(path, at)) != line.npos; at += shown.size())
            line.replace(at, path.size(), shown);
        if (line.starts_with("In file included from") || line.starts_with("                 from")) continue;
        const bool tells_header = line.find("did you forget to ‘#include") != line.npos;
        const std::string header = missing_header(line);
        if (!header.empty()) line = header;
        const bool starts_note = line.find(": note:") != line.npos || line.find(": warning:") != line.npos;
        if (line.find("error:") != line.npos)
            relevant = true;
        else if (starts_note || line.find(": In ") != line.npos)
            relevant = false;
        if (!relevant && !tells_header) continue;
        if (!header.empty()) relevant = false;  // what follows shows the other name
        if (line.size() > 300) line = line.substr(0, 300) + "...";
        text += line + "\n";
        ++count;
    }
    return text;
}

/// The first warnings about the source itself, a line each, those that matter before others; none about what it
/// includes.
std::string first_warnings(const std::string& output, const std::string& path, const std::string& shown) {
    constexpr std::size_t most = 3;
    std::istringstream lines(output);
    std::vector<std::string> all;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(path + ":") || line.find(": warning: ") == line.npos) continue;
        line.replace(0, path.size(), shown);
        if (line.size() > 300) line = line.substr(0, 300) + "...";
        if (std::ranges::count(all, line) == 0) all.push_back(line);
    }
    // what is only unused breaks nothing
    std::stable_partition(all.begin(), all.end(),
                          [](const std::string& line) { return line.find("[-Wunused") == line.npos; });
    std::string text;
    for (std::size_t i = 0; i < std::min(most, all.size()); ++i) text += all[i] + "\n";
    if (all.size() > most) text += fmt::format("and {} more\n", all.size() - most);
    return text;
}

/// Why a tool was cut off before it could say what is wrong with a source; empty: it was not.
std::string cut_off(const Ending& ending, const char* who, double seconds = tool_seconds) {
    const auto said = [&](const char* words) { return ending.err.find(words) != ending.err.npos; };
    if (ending.waited) return fmt::format("{} waits for something on it, and was stopped", who);
    if (ending.how == Ending::How::timed_out || said("CPU time limit exceeded") || said("[CPU time"))
        return fmt::format("{} ran longer than {:g} s on it", who, seconds);
    if (said("File size limit exceeded") || said("File too large") || said("[File size"))
        return fmt::format("{} writes more than {} MB for it", who, most_object_bytes >> 20);
    if (said("out of memory") || said("virtual memory exhausted") || said("Cannot allocate memory") ||
        said("memory exhausted") || said("Killed signal terminated"))
        return fmt::format("{} uses more than 3 GB of memory on it", who);
    if (ending.how == Ending::How::signalled)
        return fmt::format("{} broke down on it: {}", who, signal_in_words(ending.code));
    if (said("signal terminated program") || said("internal compiler error"))
        return fmt::format("{} broke down on it", who);
    return {};
}

std::string why_not_built(const Ending& ending, const std::string& path, const std::string& shown, double seconds) {
    const std::string cut = cut_off(ending, "the compiler", seconds);
    if (!cut.empty()) return shown + ": error: " + cut;
    const std::string errors = first_errors(ending.err, path, shown);
    return errors.empty() ? fmt::format("the compiler failed:\n{}", ending.err.substr(0, 600)) : errors;
}

std::vector<std::string> compiler_of(const Toolchain& chain) {
    std::vector<std::string> command{chain.compiler.string()};
    command.insert(command.end(), chain.compile.begin(), chain.compile.end());
    command.insert(command.end(), {"-Wall", "-Wextra", "-fdiagnostics-color=never", "-fno-lto"});
    return command;
}

/// After a failure: throws where the machine cannot even compile an empty file now.
void check_compiler(const Toolchain& chain, const Sandbox& sandbox, const fs::path& work) {
    require_room(work, most_object_bytes);
    const fs::path source = work / "empty.cpp";
    write_text(source, "");
    std::vector<std::string> command = compiler_of(chain);
    command.insert(command.end(), {"-c", source.string(), "-o", (work / "empty.o").string()});
    const Ending ending = run(sandbox, tool(command, work));
    if (!ending.good())
        throw std::runtime_error(
            fmt::format("the compiler does not work on this machine now, not even on an empty file: {}",
                        ending.err.empty() ? "it says nothing" : ending.err.substr(0, 300)));
}

/// What a tool has made, where it may go on to the next one. Throws BadObject where it may not.
ObjectFile object_at(const fs::path& path) {
    const auto bytes = read_text(path, most_object_bytes);
    if (!bytes) throw BadObject("there is no object");
    const ObjectFile object = read_object(*bytes);
    if (const std::string fault = object_fault(object); !fault.empty()) throw BadObject(fault);
    return object;
}

/// Whether nothing of it meets other objects but the one function that it defines: then there is nothing to hide.
bool is_private(const ObjectFile& object) {
    const auto has = [&](const char* section) { return std::ranges::count(object.sections, section) > 0; };
    return object.defined.size() == 1 && !has(".group") && !has(".linker-options");
}

/// What the compiler reads of the folders that it searches: of the assignment's, where fragments may be filled in, the
/// framework's headers alone.
std::vector<fs::path> readable_of(const Toolchain& chain, std::vector<fs::path> folders) {
    std::ranges::replace(folders, chain.includes.front(), chain.includes.front() / "rt");
    return folders;
}

}  // namespace

Compiled compile_fragment(const Toolchain& chain, const Sandbox& sandbox, const std::string& fragment,
                          const std::string& text, const std::string& shown, const fs::path& work, double seconds) {
    const fs::path source = work / (fragment + ".cpp"), compiled = work / "compiled.o";
    write_text(source, text);

    const auto compile = [&](std::vector<fs::path> includes, std::vector<std::string> options) {
        std::vector<std::string> command = compiler_of(chain);
        command.insert(command.end(), options.begin(), options.end());
        for (const fs::path& folder : includes) command.insert(command.end(), {"-I", folder.string()});
        command.insert(command.end(), {"-c", source.string(), "-o", compiled.string()});
        fs::remove(compiled);  // of an earlier try, maybe by another user
        return run(sandbox, tool(command, work, readable_of(chain, includes), seconds));
    };
    std::vector<fs::path> searched = chain.includes;
    const fs::path header = precompiled_header(chain);
    if (!header.empty()) searched.insert(searched.begin(), header);
    Ending compiler = compile(searched, {});
    if (!compiler.good() && !header.empty() && cut_off(compiler, "").empty())
        compiler = compile(chain.includes, {});  // that header lacks a little
    if (!compiler.good()) {
        check_compiler(chain, sandbox, work);  // else no fault of the submission
        // behind more warnings than are kept
        if (compiler.err.find("error:") == compiler.err.npos && cut_off(compiler, "").empty())
            compiler = compile(chain.includes, {"-w"});
        const std::string fault = source_fault(text, shown);
        return {false, {}, fault.empty() ? why_not_built(compiler, source.string(), shown, seconds) : fault, {}};
    }

    const auto symbol = chain.symbols.find(fragment);
    if (symbol == chain.symbols.end()) return {false, {}, "the framework calls no fragment of this name", {}};
    const fs::path merged = work / "merged.o", own = work / (fragment + ".o");
    Ending step;
    try {
        const ObjectFile object = object_at(compiled);
        if (std::ranges::count(object.defined, symbol->second) == 0)
            return {false, {}, wrong_signature(chain, sandbox, object, fragment, shown, work), {}};
        if (is_private(object)) {
            fs::rename(compiled, own);
            return {true, own, {}, first_warnings(compiler.err, source.string(), shown)};
        }
        // groups of sections that other objects hold as well must go before their symbols become private
        static const std::string merge =
            "/usr/bin/ld -r --force-group-allocation \"$1\" -o \"$2\" && "
            "/usr/bin/objcopy --remove-section=.linker-options \"$4\" \"$2\" \"$3\"";
        step = run(sandbox, tool({"/bin/sh", "-c", merge, "sh", compiled.string(), merged.string(), own.string(),
                                  "--keep-global-symbol=" + symbol->second},
                                 work));
        if (step.good())
            return object_at(own), Compiled{true, own, {}, first_warnings(compiler.err, source.string(), shown)};
    } catch (const BadObject& error) {
        return {false, {}, fmt::format("{}: error: {}", shown, error.what()), {}};
    }
    check_compiler(chain, sandbox, work);
    const std::string cut = cut_off(step, "the linker");
    return {false,
            {},
            fmt::format("{}: error: its object cannot be prepared for the link: {}", shown,
                        cut.empty() ? step.err.substr(0, 300) : cut),
            {}};
}

std::string link_child(const Toolchain& chain, const Sandbox& sandbox, const std::vector<fs::path>& objects,
                       const fs::path& program) {
    const fs::path folder = program.parent_path();
    const fs::path made = folder / "objects";
    fs::create_directory(made);
    std::vector<fs::path> readable;
    std::vector<std::string> command{chain.compiler.string()};
    command.insert(command.end(), chain.link.begin(), chain.link.end());
    command.insert(command.end(),
                   {"-fno-lto", "-fno-use-linker-plugin"});  // no compiler runs on what a fragment may hold
    for (const fs::path& object : objects) {
        if (chain.is_given(object)) {  // the step can read no other object of the solution, nor change these
            readable.push_back(object), command.push_back(object.string());
        } else {  // it may lie where only this user can read
            const fs::path copy = made / object.filename();
            fs::copy_file(object, copy, fs::copy_options::overwrite_existing);
            command.push_back(copy.string());
        }
    }
    for (const fs::path& archive : chain.archives) command.push_back(archive.string()), readable.push_back(archive);
    for (const std::string& library : chain.libraries)
        if (library.starts_with("/") && (!library.starts_with("/usr/") || chain.is_own(library)))
            readable.emplace_back(library);
    command.insert(command.end(), chain.libraries.begin(), chain.libraries.end());
    command.insert(command.end(), {"-o", program.string()});

    const Ending linker = run(sandbox, tool(command, folder, readable));
    fs::remove_all(made);
    if (linker.good()) return {};
    require_room(folder, most_object_bytes);
    if (const std::string cut = cut_off(linker, "the linker"); !cut.empty()) return cut;

    std::istringstream lines(linker.err);
    std::string text;
    int count = 0;
    for (std::string line; std::getline(lines, line) && count < 4;)
        if (const std::size_t at = line.find("undefined reference"); at != line.npos) {
            text +=
                "error: " + line.substr(at, 300) + ": it is declared and called, but defined nowhere in this file\n";
            ++count;
        }
    return text.empty() ? fmt::format("the link failed:\n{}", linker.err.substr(0, 600)) : text;
}

}  // namespace grade
