#include "commands/words.h"

#include <fmt/format.h>

#include <algorithm>

#include "rt/files/scene_reader.h"
#include "rt/files/toml_table.h"

namespace grade {

Chosen choose(const std::vector<std::string>& words, const Toolchain& chain, const Assignment& assignment) {
    const auto names = assignment.names();
    Chosen chosen;
    std::error_code error;
    for (const std::string& word : words) {
        if (std::ranges::count(names, word) > 0) {
            chosen.fragments.insert(word);
        } else if (word.ends_with(".cpp") && std::ranges::count(names, fs::path(word).stem().string()) > 0) {
            throw rt::InputError(
                fmt::format("{}: a file of one fragment; expected its name: {}", word, fs::path(word).stem().string()));
        } else if (fs::exists(word, error) || word.find_first_of("/.") != word.npos) {
            if (!chosen.submission.empty())
                throw rt::InputError(
                    fmt::format("{}: one submission too many, after {}; expected one, and names of fragments", word,
                                chosen.submission));
            chosen.submission = word;
        } else if (chain.solution_objects.contains(word)) {
            throw rt::InputError(
                fmt::format("{0}: assignment.toml leaves this fragment out, so it is handed out filled in, and not "
                            "graded; expected {{ name = \"{0}\", points = ... }} there, or another fragment",
                            word));
        } else {
            const auto nearest = rt::nearest_word(word, names);
            throw rt::InputError(fmt::format("{}: no fragment has this name, and there is no such folder; expected {}",
                                             word, nearest ? *nearest + "?" : "a name that assignment.toml lists"));
        }
    }
    const fs::path starter = chain.source / "starter";
    if (chosen.submission.empty() && chain.cache.empty())
        throw rt::InputError("no submission; expected a folder, a .zip or a .tar.gz: grade SUBMISSION");
    if (chosen.submission.empty()) chosen.submission = starter.string();
    for (const fs::path& place : {starter, starter / "fragments"})
        chosen.own = chosen.own || fs::equivalent(chosen.submission, place, error);
    return chosen;
}

}  // namespace grade
