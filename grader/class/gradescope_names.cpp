#include "class/gradescope_names.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "files/files.h"

namespace grade::course {

namespace {

/// A character by its number.
std::string utf8(unsigned long code) {
    if (code < 0x80) return {char(code)};
    std::string text;
    for (; code >= (text.empty() ? 0x40u : 0x40u >> text.size()); code >>= 6)
        text.insert(text.begin(), char(0x80 | (code & 0x3f)));
    text.insert(text.begin(), char((0xf00u >> (text.size() + 1) & 0xff) | code));
    return text;
}

/// What a value of YAML, on one line, stands for.
std::string unquoted(const std::string& value) {
    if (value.size() < 2 || value.front() != value.back()) return value;
    const char quote = value.front();
    if (quote != '\'' && quote != '"') return value;
    std::string text;
    for (std::size_t i = 1; i + 1 < value.size(); ++i) {
        const char c = value[i];
        if (c != (quote == '"' ? '\\' : quote) || i + 2 >= value.size()) {
            text += c;
            continue;
        }
        const char escaped = value[++i];
        constexpr std::string_view letters = "abtnvfre0", codes = "\a\b\t\n\v\f\r\x1b";
        const std::size_t digits = escaped == 'x' ? 2 : escaped == 'u' ? 4 : escaped == 'U' ? 8 : 0;
        if (quote == '"' && digits > 0) {
            const unsigned long code = std::strtoul(value.substr(i + 1, digits).c_str(), nullptr, 16);
            text += utf8(code < 0x110000 ? code : 0xfffd);
            i += digits;
        } else if (const std::size_t at = letters.find(escaped); quote == '"' && at != letters.npos) {
            text += at < codes.size() ? codes[at] : '\0';
        } else {
            text += escaped;
        }
    }
    return text;
}

/// Names and numbers from Gradescope's submission_metadata.yml, of which only these lines are read:
///
///     submission_123:
///       :submitters:
///       - :name: Jane Doe
///         :sid: '4711'
void read_names(const std::string& text, std::vector<Entry>& entries) {
    std::istringstream lines(text);
    Entry* entry = nullptr;
    const auto value_of = [](const std::string& line, const char* key) -> std::string {
        const std::size_t at = line.find(key);
        if (at == line.npos || line.find_first_not_of(" -") != at) return {};
        std::string value = line.substr(at + std::string_view(key).size());
        const std::size_t begin = value.find_first_not_of(' '), end = value.find_last_not_of(" \r");
        if (begin == value.npos) return {};
        return unquoted(value.substr(begin, end - begin + 1));
    };
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("submission_")) {
            const std::string name = line.substr(0, line.find(':'));
            const auto found = std::ranges::find(entries, name, &Entry::path);
            entry = found == entries.end() ? nullptr : &*found;
        }
        if (!entry) continue;
        if (const std::string name = value_of(line, ":name:"); !name.empty())
            entry->student.name = entry->student.name == entry->path ? name : entry->student.name + ", " + name;
        if (const std::string id = value_of(line, ":sid:"); !id.empty()) entry->student.id = id;
    }
}

}  // namespace

void add_gradescope_names(const fs::path& folder, std::vector<Entry>& entries) {
    const fs::path file = folder / "submission_metadata.yml";
    std::error_code error;
    if (!fs::exists(file, error)) return;
    const auto text = read_text(file, 64u << 20);
    read_names(text.value_or(""), entries);
    for (Entry& entry : entries)
        if (entry.student.system == "Gradescope" && entry.student.name == entry.path)
            entry.notes.emplace_back(
                "submission_metadata.yml has no name for it; expected the file whole, as Gradescope exported it");
}

}  // namespace grade::course
