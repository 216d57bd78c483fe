#include "submission/framework.h"

#include <algorithm>

#include "files/files.h"

namespace grade {

namespace {

/// Line ends are the editor's.
std::string without_returns(std::string text) {
    std::erase(text, '\r');
    return text;
}

}  // namespace

/// From the last folder rt/ on.
fs::path FrameworkFiles::file(const std::string& path) const {
    const std::size_t at = ("/" + path).rfind("/rt/");
    return folder_.empty() || at == path.npos ? fs::path() : folder_ / path.substr(at);
}

bool FrameworkFiles::has(const std::string& path) const {
    std::error_code error;
    const fs::path own = file(path);
    return !own.empty() && fs::is_regular_file(own, error);
}

bool FrameworkFiles::differs(const std::string& path, const std::string& text) const {
    const auto own = read_text(file(path));
    return own && without_returns(*own) != without_returns(text);
}

std::vector<std::string> FrameworkFiles::edited_in(const fs::path& submission, const std::string& within) const {
    std::vector<std::string> edited;
    std::error_code error;
    if (folder_.empty() || fs::equivalent(submission / within / "rt", folder_ / "rt", error)) return edited;
    fs::recursive_directory_iterator at(folder_ / "rt", error);
    for (const fs::recursive_directory_iterator end; !error && at != end; at.increment(error)) {
        const std::string path = within + at->path().lexically_relative(folder_).generic_string();
        if (!at->is_regular_file(error) || !fs::is_regular_file(fs::symlink_status(submission / path, error))) continue;
        if (const auto text = read_text(submission / path, most_source_bytes); text && differs(path, *text))
            edited.push_back(path);
    }
    std::ranges::sort(edited);
    return edited;
}

}  // namespace grade
