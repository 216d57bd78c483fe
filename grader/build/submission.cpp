#include "build/submission.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "build/archive.h"
#include "build/files.h"

namespace grade {

namespace {

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

Found look_into_folder(const fs::path& folder, const std::vector<std::string>& fragments) {
    Found found;
    look_at(folder, "", fragments, found);
    std::error_code error;
    const auto is_folder = [&](const fs::path& path) {
        return fs::symlink_status(path, error).type() == fs::file_type::directory;
    };
    if (is_folder(folder / "fragments")) look_at(folder / "fragments", "fragments/", fragments, found);
    if (is_folder(folder / "starter")) {
        if (is_folder(folder / "starter/fragments"))
            look_at(folder / "starter/fragments", "starter/fragments/", fragments, found);
    }
    return found;
}

/// Of the folders that hold fragments, the one to take: the one with most of them; of two with as many, the shorter
/// path.
std::string best_folder(const Found& found) {
    std::map<std::string, int> counts;
    const auto folder_of = [](const std::string& path) { return path.substr(0, path.rfind('/') + 1); };
    for (const auto& [path, text] : found.texts) ++counts[folder_of(path)];
    for (const auto& [path, complaint] : found.complaints) ++counts[folder_of(path)];
    std::string best;
    int most = 0;
    for (const auto& [folder, count] : counts) {
        // what macOS adds to archives is no submission
        if (folder.starts_with("__MACOSX")) continue;
        if (count > most || (count == most && folder.size() < best.size())) best = folder, most = count;
    }
    return best;
}

}  // namespace

std::string too_large() {
    return fmt::format("larger than {} KiB; a fragment is a few lines", most_source_bytes / 1024);
}

Submission read_submission(const fs::path& path, const std::vector<std::string>& fragments) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw SubmissionError(fmt::format("{}: not there; expected a folder, a .zip or a .tar.gz", path.string()));
    const Found found =
        fs::is_directory(status) ? look_into_folder(path, fragments) : look_into_archive(path, fragments);

    Submission submission;
    submission.name = path.string();
    submission.folder = best_folder(found);
    for (const std::string& fragment : fragments) {
        const std::string file = submission.folder + fragment + ".cpp";
        if (const auto text = found.texts.find(file); text != found.texts.end())
            submission.texts[fragment] = text->second;
        if (const auto complaint = found.complaints.find(file); complaint != found.complaints.end())
            submission.complaints[fragment] = complaint->second;
    }
    if (submission.texts.empty() && submission.complaints.empty())
        throw SubmissionError(fmt::format("{}: holds no fragment; expected files such as fragments/{}.cpp",
                                          path.string(), fragments.empty() ? "NAME" : fragments.front()));
    return submission;
}

}  // namespace grade
