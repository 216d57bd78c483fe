#include "authoring/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "files/files.h"
#include "rt/files/scene_reader.h"

namespace grade::authoring {

std::string must_read(const fs::path& path) {
    const auto text = read_text(path);
    if (!text) throw rt::InputError(path.string() + ":1:1: cannot be read; expected a file of the assignment");
    return *text;
}

std::optional<Declaration> declaration_of(const std::string& fragment, const std::string& header) {
    const auto signature = signature_of(fragment, header);
    if (!signature) return std::nullopt;
    std::istringstream lines(header);
    for (std::string line; std::getline(lines, line);)
        if (line.ends_with(");") && line.find(" " + fragment + "(") != line.npos && std::isalpha(line[0]))
            return Declaration{line, *signature};
    return std::nullopt;
}

std::vector<std::string> comment_of(const std::string& fragment, const std::string& text) {
    std::istringstream lines(text);
    std::vector<std::string> comment;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("///"))
            comment.push_back(line.substr(std::min<std::size_t>(4, line.size())));
        else if (line.find(" " + fragment + "(") != line.npos && !line.starts_with(" "))
            return comment;
        else
            comment.clear();
    }
    return {};
}

std::optional<std::string> section_of(const std::string& fragment, const std::string& handout) {
    const std::size_t at = handout.find("\n### " + fragment + "\n");
    if (at == handout.npos) return std::nullopt;
    const std::size_t end = std::min(handout.find("\n### ", at + 1), handout.find("\n## ", at + 1));
    return handout.substr(at + 1, end == handout.npos ? end : end - at);
}

std::string place_of(const fs::path& file, const std::string& text, std::size_t at) {
    return fmt::format("{}:{}:1", file.string(), 1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'));
}

}  // namespace grade::authoring
