#include "submission/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <locale.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <set>

#include "submission/framework.h"

namespace grade {

namespace {

constexpr int most_entries = 20'000;
constexpr std::int64_t most_unpacked = 256ll << 20, most_taken = 32ll << 20;

/// While it lives, this thread's names are UTF-8, without which the library gives up on all that are not ASCII.
class NamesInUtf8 {
public:
    NamesInUtf8() {
        for (const char* name : {"C.UTF-8", "C.utf8", "en_US.UTF-8", "en_GB.UTF-8"})
            if (!locale_) locale_ = newlocale(LC_CTYPE_MASK, name, locale_t(0));
        if (locale_) before_ = uselocale(locale_);
    }
    ~NamesInUtf8() {
        if (!locale_) return;
        uselocale(before_);
        freelocale(locale_);
    }
    NamesInUtf8(const NamesInUtf8&) = delete;
    NamesInUtf8& operator=(const NamesInUtf8&) = delete;

private:
    locale_t locale_ = locale_t(0), before_ = locale_t(0);
};

/// A path within an archive, as a name and nothing else; some programs write it with the other slash.
std::string plain_path(std::string raw) {
    std::replace(raw.begin(), raw.end(), '\\', '/');
    return fs::path(raw).lexically_normal().generic_string();
}

/// At most `most` bytes of an entry, and one more where there are more; none where it is broken.
std::optional<std::string> text_of_entry(archive* in, std::size_t most) {
    std::string text(most + 1, '\0');
    std::size_t have = 0;
    for (la_ssize_t got;
         have < text.size() && (got = archive_read_data(in, text.data() + have, text.size() - have)) != 0;) {
        if (got < 0) return std::nullopt;
        have += std::size_t(got);
    }
    text.resize(have);
    text.shrink_to_fit();
    return text;
}

}  // namespace

Found look_into_archive(const fs::path& path, const std::vector<std::string>& fragments, const fs::path& framework) {
    const FrameworkFiles handed_out(framework);
    const NamesInUtf8 names_in_utf8;
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
    std::int64_t unpacked = 0, taken = 0;
    for (int entries = 0;; ++entries) {
        archive_entry* entry = nullptr;
        const int status = archive_read_next_header(in.get(), &entry);
        if (status == ARCHIVE_EOF) break;
        if (status < ARCHIVE_WARN) fail();
        if (entries >= most_entries)
            throw SubmissionError(fmt::format("{}: holds more than {} files", path.string(), most_entries));
        const char* raw = archive_entry_pathname(entry);
        if (!raw) {
            ++found.unnamed;
            continue;
        }
        // the path is a name and nothing else: nothing is written to it
        const std::string name = plain_path(raw);
        if (name.starts_with("/") || name.starts_with("..")) continue;
        if (!names.contains(fs::path(name).filename().string())) {
            if (archive_entry_filetype(entry) == AE_IFREG) found.look_at_name(name, fragments);
            if (archive_entry_filetype(entry) == AE_IFREG && handed_out.has(name)) {
                const auto text = text_of_entry(in.get(), most_source_bytes);
                if (!text) fail();
                if (!archive_entry_size_is_set(entry)) unpacked += std::int64_t(text->size());
                if (handed_out.differs(name, *text)) found.edited.insert(name);
            }
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
        const auto read = text_of_entry(in.get(), most_source_bytes);
        if (!read) fail();
        std::string text = *read;
        if (text.size() > most_source_bytes) {
            found.complaints[name] = too_large();
            continue;
        }
        if ((taken += std::int64_t(text.size())) > most_taken)
            throw SubmissionError(fmt::format("{}: holds more than {} MiB in files that are named like fragments",
                                              path.string(), most_taken >> 20));
        const auto [place, fresh] = found.texts.try_emplace(name, text);
        if (!fresh && place->second != text) found.doubled.insert(name);
        place->second = std::move(text);
    }
    return found;
}

}  // namespace grade
