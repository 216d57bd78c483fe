#include <fmt/format.h>

#include <algorithm>

#include "files/files.h"
#include "submission/archive.h"
#include "submission/near_name.h"

namespace grade {

namespace {

constexpr int most_files = 20'000, deepest_folder = 6;

void look_at(const fs::path& folder, const std::string& prefix, const std::vector<std::string>& fragments,
             Found& found) {
    for (const std::string& fragment : fragments) {
        const std::string file = fragment + ".cpp";
        const fs::path path = folder / file;
        std::error_code error;
        const fs::file_status status = fs::symlink_status(path, error);
        if (status.type() == fs::file_type::not_found) continue;
        if (status.type() != fs::file_type::regular) {
            found.complaints[prefix + file] = "not a regular file; links and devices are not followed";
        } else if (auto text = read_text(path, most_source_bytes)) {
            found.texts[prefix + file] = std::move(*text);
        } else {
            found.complaints[prefix + file] =
                fs::file_size(path, error) > most_source_bytes ? too_large() : "cannot be read";
        }
    }
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::symlink_status(path, error).type() == fs::file_type::directory;
}

void look_at_names(const fs::path& folder, const std::string& prefix, const std::vector<std::string>& fragments,
                   Found& found) {
    std::error_code error;
    int count = 0;
    for (fs::directory_iterator at(folder, error), end; !error && at != end && ++count < most_files;
         at.increment(error))
        if (fs::symlink_status(at->path(), error).type() == fs::file_type::regular)
            found.look_at_name(prefix + at->path().filename().string(), fragments);
}

/// Into the archives beside fragments: what is there may be more. One that is too large stays where it is.
void look_beside(const fs::path& folder, const std::vector<std::string>& fragments, const fs::path& framework,
                 Found& found) {
    Found more = found;
    try {
        look_into_archives(folder, fragments, framework, more);
        found = std::move(more);
    } catch (const SubmissionError& error) {
        found.broken = error.what();
    }
    // a note goes into tables, where the place on this machine says nothing
    const std::string place = (folder / "").string();
    for (std::size_t at; (at = found.broken.find(place)) != found.broken.npos;) found.broken.erase(at, place.size());
}

}  // namespace

void Found::look_at_name(const std::string& path, const std::vector<std::string>& fragments) {
    const std::string file = fs::path(path).filename().string();
    if (const auto fragment = nearly_named(file, fragments)) near[path] = *fragment;
    for (const char* ending : {".zip", ".tar", ".tar.gz", ".tgz", ".7z", ".rar", ".tar.xz", ".tar.bz2"})
        if (file.ends_with(ending) && !path.starts_with("__MACOSX")) archives.push_back(path);
}

std::string too_large() {
    return fmt::format("larger than {} KiB; a fragment is a few lines", most_source_bytes / 1024);
}

Found look_into_folder(const fs::path& folder, const std::vector<std::string>& fragments, const fs::path& framework) {
    Found found;
    const auto look = [&](const std::string& prefix) {
        look_at(folder / prefix, prefix, fragments, found);
        look_at_names(folder / prefix, prefix, fragments, found);
    };
    look("");
    for (const char* usual : {"fragments/", "starter/fragments/"})
        if (is_folder(folder / fs::path(usual).parent_path()) && is_folder(folder / *fs::path(usual).begin()))
            look(usual);
    if (!found.texts.empty() || !found.complaints.empty()) {
        look_beside(folder, fragments, framework, found);
        return found;
    }
    std::error_code error;
    std::vector<std::string> inside;
    int count = 0;
    fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
    for (const fs::recursive_directory_iterator end; !error && at != end && ++count < most_files; at.increment(error)) {
        if (!is_folder(at->path())) continue;
        const std::string name = at->path().filename().string();
        if (name.starts_with(".") || name == "build" || at.depth() >= deepest_folder)
            at.disable_recursion_pending();
        else
            inside.push_back(at->path().lexically_relative(folder).generic_string() + "/");
    }
    std::ranges::sort(inside);
    for (const std::string& prefix : inside) look(prefix);
    if (found.texts.empty() && found.complaints.empty()) look_into_archives(folder, fragments, framework, found);
    return found;
}

}  // namespace grade
