#include "submission/near_name.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "files/words.h"
#include "rt/files/toml_table.h"

namespace grade {

namespace {

constexpr std::array sources{"cpp", "cc",  "cxx",  "c++", "c",    "cp",  "hpp",  "hxx", "hh",
                             "h",   "txt", "text", "bak", "orig", "old", "save", "cpp~"};

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

/// Letters and digits alone.
std::string bare(std::string_view text) {
    std::string out;
    for (const char c : text)
        if (std::isalnum(static_cast<unsigned char>(c))) out += c;
    return out;
}

/// The name without what it ends in; empty: it is no source.
std::string stem_of(std::string_view file) {
    std::string name = lower(file);
    bool source = false;
    for (std::size_t dot; (dot = name.rfind('.')) != name.npos && dot > 0;) {
        std::string ending = name.substr(dot + 1);
        ending = ending.substr(0, ending.find_first_of(" (-_"));  // "hit_sphere.cpp (1)", as some save it
        if (std::find(sources.begin(), sources.end(), ending) == sources.end()) break;
        name.resize(dot), source = true;
    }
    return source ? name : "";
}

/// Whether a word stands in a text with no letter next to it.
bool has_word(std::string_view text, std::string_view word) {
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        if ((at == 0 || !is_letter(text[at - 1])) && (end == text.size() || !is_letter(text[end]))) return true;
    }
    return false;
}

}  // namespace

std::optional<std::string> nearly_named(std::string_view file, const std::vector<std::string>& fragments) {
    for (const std::string& fragment : fragments)
        if (file == fragment + ".cpp") return {};
    if (file.starts_with("._")) return {};  // what macOS keeps beside a file
    const std::string stem = stem_of(file), letters = bare(stem);
    if (letters.empty()) return {};
    std::optional<std::string> best;
    for (const std::string& fragment : fragments) {
        std::string words = stem;
        std::replace_if(
            words.begin(), words.end(), [](char c) { return c == '-' || c == ' ' || c == '.'; }, '_');
        const bool holds = has_word(words, fragment) || has_word(stem, bare(fragment)) || letters == bare(fragment);
        if (holds && (!best || fragment.size() > best->size())) best = fragment;
    }
    if (best) return best;
    std::vector<std::string> names;
    for (const std::string& fragment : fragments) names.push_back(bare(fragment));
    const auto nearest = rt::nearest_word(letters, names);
    const std::size_t differ = letters.size() / 5;  // letters, in a slip of the fingers
    if (!nearest || letters.size() < 5 || letters.size() + differ < nearest->size() ||
        nearest->size() + differ < letters.size())
        return {};
    return fragments[std::size_t(std::find(names.begin(), names.end(), *nearest) - names.begin())];
}

bool is_set_aside(std::string_view folder) {
    const std::string name = lower(folder);
    for (const char* word : {"old", "older", "backup", "backups", "bak", "copy", "copies", "previous", "prev", "orig",
                             "original", "archive", "archived", "trash", "unused"})
        if (has_word(name, word)) return true;
    return name.starts_with(".");
}

}  // namespace grade
