#include "build/submission.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "build/files.h"

namespace grade {

namespace {

constexpr int most_entries = 20'000;
constexpr std::int64_t most_unpacked = 256ll << 20;

/// A submission's files by path, those that could be fragments: FRAGMENT.cpp in any folder.
struct Found {
    std::map<std::string, std::string> texts, complaints;
};

std::string too_large() {
    return fmt::format("larger than {} KiB; a fragment is a few lines", most_source_bytes / 1024);
}

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

Found look_into_archive(const fs::path& path, const std::vector<std::string>& fragments) {
    const std::unique_ptr<archive, int (*)(archive*)> in(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(in.get());
    archive_read_support_format_tar(in.get());
    archive_read_support_filter_gzip(in.get());
    const auto fail = [&] {
        const char* why = archive_error_string(in.get());
        throw SubmissionError(fmt::format("{}: cannot be unpacked: {}; expected a .zip or a .tar.gz", path.string(),
                                          why ? why : "broken"));
    };
    if (archive_read_open_filename(in.get(), path.c_str(), 1 << 16) != ARCHIVE_OK) fail();

    std::set<std::string> names;
    for (const std::string& fragment : fragments) names.insert(fragment + ".cpp");
    Found found;
    std::int64_t unpacked = 0;
    for (int entries = 0;; ++entries) {
        archive_entry* entry = nullptr;
        const int status = archive_read_next_header(in.get(), &entry);
        if (status == ARCHIVE_EOF) break;
        if (status < ARCHIVE_WARN) fail();
        if (entries >= most_entries)
            throw SubmissionError(fmt::format("{}: holds more than {} files", path.string(), most_entries));
        const char* raw = archive_entry_pathname(entry);
        if (!raw) continue;
        // the path is a name and nothing else: nothing is written to it
        const std::string name = fs::path(raw).lexically_normal().generic_string();
        if (name.starts_with("/") || name.starts_with("..")) continue;
        if (!names.contains(fs::path(name).filename().string())) {
            // what is skipped is unpacked all the same
            if (archive_entry_size_is_set(entry)) unpacked += archive_entry_size(entry);
            if (unpacked > most_unpacked)
                throw SubmissionError(
                    fmt::format("{}: unpacks to more than {} MiB", path.string(), most_unpacked >> 20));
            continue;
        }
        if (archive_entry_filetype(entry) != AE_IFREG || archive_entry_hardlink(entry)) {
            found.complaints[name] = "not a regular file; links and devices are not followed";
            continue;
        }
        std::string text(most_source_bytes + 1, '\0');
        std::size_t have = 0;
        for (la_ssize_t got;
             have < text.size() && (got = archive_read_data(in.get(), text.data() + have, text.size() - have)) != 0;) {
            if (got < 0) fail();
            have += std::size_t(got);
        }
        if (have > most_source_bytes) {
            found.complaints[name] = too_large();
            continue;
        }
        text.resize(have);
        found.texts[name] = std::move(text);
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
