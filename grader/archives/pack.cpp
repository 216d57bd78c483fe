#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "files/files.h"
#include "submission/archive.h"

namespace grade {

namespace {

/// All files at or below a path, in an order of their own.
std::vector<std::pair<std::string, fs::path>> files_of(const std::string& name, const fs::path& path) {
    if (!fs::is_directory(path)) return {{name, path}};
    std::vector<std::pair<std::string, fs::path>> all;
    for (const auto& entry : fs::recursive_directory_iterator(path))
        if (entry.is_regular_file())
            all.emplace_back(name + "/" + entry.path().lexically_relative(path).generic_string(), entry.path());
    std::ranges::sort(all);
    return all;
}

}  // namespace

void write_zip(const fs::path& zip, const std::vector<std::pair<std::string, fs::path>>& entries) {
    // whole or not at all
    const fs::path draft = zip.string() + ".tmp";
    const std::unique_ptr<archive, int (*)(archive*)> out(archive_write_new(), archive_write_free);
    const auto must = [&](la_ssize_t status) {
        if (status >= ARCHIVE_WARN) return;
        const char* why = archive_error_string(out.get());
        const std::string words =
            fmt::format("{}: cannot be written: {}", zip.string(), why ? why : "no reason is given");
        std::error_code error;
        fs::remove(draft, error);
        throw std::runtime_error(words);
    };
    must(archive_write_set_format_zip(out.get()));
    must(archive_write_open_filename(out.get(), draft.c_str()));
    for (const auto& [top, path] : entries)
        for (const auto& [name, file] : files_of(top, path)) {
            const auto text = read_text(file, std::uint64_t(1) << 30);
            if (!text) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
            const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry(archive_entry_new(),
                                                                                 archive_entry_free);
            archive_entry_set_pathname(entry.get(), name.c_str());
            archive_entry_set_size(entry.get(), la_int64_t(text->size()));
            archive_entry_set_filetype(entry.get(), AE_IFREG);
            const bool program = (fs::status(file).permissions() & fs::perms::owner_exec) != fs::perms::none;
            archive_entry_set_perm(entry.get(), program ? 0755 : 0644);
            must(archive_write_header(out.get(), entry.get()));
            must(archive_write_data(out.get(), text->data(), text->size()));
        }
    must(archive_write_close(out.get()));
    fs::rename(draft, zip);
}

}  // namespace grade
