#include "programs/preprocess.h"

#include <regex>
#include <sstream>

#include "files/files.h"

namespace grade {

namespace {

constexpr std::size_t most_bytes = 256 << 10;  // of what comes out
constexpr double most_seconds = 2;
constexpr const char* kept_include = "#pragma kept_include";  // a preprocessor leaves a pragma that it does not know

/// The lines with which a word for the preprocessor begins, and this one in place of the first.
std::string with_word(const std::string& text, const std::string& pattern, const char* word) {
    std::istringstream lines(text);
    const std::regex begins(pattern);
    std::string all;
    for (std::string line; std::getline(lines, line);)
        all += (line.size() < 1000 ? std::regex_replace(line, begins, word) : line) + "\n";
    return all;
}

/// What a preprocessor writes, without its marks "# LINE "FILE"", each line of the source at its place. None: a line
/// would have to go back.
std::optional<std::string> in_place(const std::string& output, const std::string& source) {
    static const std::regex mark("# ([0-9]{1,7}) \"([^\"]*)\".*");
    std::istringstream lines(output);
    std::string all;
    bool is_own = false;
    long at = 1;  // the line that comes next
    std::smatch found;
    for (std::string line; std::getline(lines, line);) {
        if (line.size() < 1000 && std::regex_match(line, found, mark)) {
            is_own = found[2].str() == source;
            if (!is_own) continue;
            const long due = std::stol(found[1].str());
            if (due < at && due > 0) return std::nullopt;
            if (std::size_t(due) > most_bytes) return std::nullopt;
            for (; at < due; ++at) all += "\n";
        } else if (is_own) {
            all += line + "\n", ++at;
        }
    }
    return all;
}

}  // namespace

std::optional<std::string> preprocessed(const Toolchain& chain, const Sandbox& sandbox, const std::string& text,
                                        const fs::path& work) {
    const fs::path source = work / "source.cpp", out = work / "preprocessed.txt";
    write_text(source, with_word(text, "^[ \t]*#[ \t]*include", kept_include));
    Step step{{chain.compiler.string(), "-E", "-std=c++20", source.string(), "-o", out.string()}, {}, work, {}};
    step.limits.cpu_seconds = step.limits.most_cpu_seconds = most_seconds;
    step.limits.wall_seconds = 10 * most_seconds;
    step.limits.memory = 1u << 30;
    step.limits.file_size = most_bytes;
    if (!run(sandbox, step).good()) return std::nullopt;
    const auto output = read_text(out, most_bytes);
    if (!output) return std::nullopt;
    const auto lines = in_place(*output, source.string());
    return lines ? std::optional(with_word(*lines, std::string("^") + kept_include, "#include")) : std::nullopt;
}

}  // namespace grade
