#include "submission/archive.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <clocale>
#include <fstream>
#include <memory>
#include <optional>
#include <set>
#include <utility>

#include "submission/framework.h"

namespace grade {

namespace {

constexpr int most_entries = 20'000, most_depth = 2, most_shown = 200;
constexpr std::int64_t most_unpacked = 256ll << 20, most_taken = 32ll << 20, most_inner = 64ll << 20;
constexpr std::uintmax_t smallest_end = 22, end_of_zip = smallest_end + 65535;  // of a zip; with its comment

/// While it lives, this thread's names are UTF-8, without which the library gives up on all that are not ASCII.
class NamesInUtf8 {
public:
    NamesInUtf8() {
        for (const char* name : {"C.UTF-8", "C.utf8", "en_US.UTF-8", "en_GB.UTF-8"})
            if (!locale_) locale_ = newlocale(LC_CTYPE_MASK, name, locale_t{});
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
    locale_t locale_ = locale_t{}, before_ = locale_t{};
};

/// A path within an archive, as a name and nothing else; some programs write it with the other slash.
std::string plain_path(std::string raw) {
    std::replace(raw.begin(), raw.end(), '\\', '/');
    return fs::path(raw).lexically_normal().generic_string();
}

/// The first and the last bytes of an archive; a zip ends with where its list of contents is.
struct Ends {
    std::string first, last;
    std::uintmax_t size = 0;
};

Ends ends_of(const fs::path& path) {
    Ends ends;
    std::error_code error;
    ends.size = fs::file_size(path, error);
    if (error) return {};
    std::ifstream file(path, std::ios::binary);
    const auto read = [&](std::string& text) {
        text.resize(std::min(ends.size, end_of_zip));
        file.read(text.data(), std::streamsize(text.size()));
        text.resize(std::size_t(std::max<std::streamsize>(file.gcount(), 0)));
    };
    read(ends.first);
    file.clear();
    file.seekg(std::streamoff(ends.size - std::min(ends.size, end_of_zip)));
    read(ends.last);
    return ends;
}

Ends ends_of(const std::string& bytes) {
    return {bytes.substr(0, end_of_zip), bytes.substr(bytes.size() - std::min(bytes.size(), std::size_t(end_of_zip))),
            bytes.size()};
}

bool is_cut_zip(const Ends& ends) {
    const std::size_t at = ends.last.rfind("PK\5\6");
    return ends.first.starts_with("PK\3\4") && (at == ends.last.npos || at + smallest_end > ends.last.size());
}

/// What is wrong with what cannot be unpacked, and what was expected.
std::string what_is_wrong(const Ends& ends, const std::string& why) {
    const std::string& first = ends.first;
    if (ends.size == 0) return "it is empty: 0 bytes; expected a .zip or a .tar.gz";
    if (why.find("assphrase") != why.npos) return "it is encrypted; expected one without a password";
    const bool is_zip = first.starts_with("PK\3\4");
    if (is_cut_zip(ends) || (!is_zip && (why.empty() || why.find("runcated") != why.npos)))
        return "it is cut off, its end is missing; expected the whole .zip or .tar.gz, uploaded again";
    const auto is = [&](std::string_view start) { return first.starts_with(start); };
    const char* kind = why.find("nrecognized") != why.npos ? "no archive" : nullptr;
    if (is("Rar!")) kind = "a .rar";
    if (is("7z\xbc\xaf")) kind = "a .7z";
    if (is("\3757zXZ") || is("BZh")) kind = "compressed in another way";
    if (is("<")) kind = "a page of the web";
    if (kind) return fmt::format("by its contents it is {}; expected a .zip or a .tar.gz", kind);
    return fmt::format("{}; expected a .zip or a .tar.gz", why.empty() ? "it is broken" : why);
}

/// Looks through an archive and, within bounds for all of them together, through those in it.
class Look {
public:
    Look(const fs::path& top, const std::vector<std::string>& fragments, const fs::path& framework)
        : top_(top), shown_(top.string()), fragments_(fragments), handed_out_(framework) {
        for (const std::string& fragment : fragments) names_.insert(fragment + ".cpp");
    }

    /// prefix  what stands before the names of what is in it: "inner.zip/"
    /// bytes   of an archive within the first one; none: that is a file, `shown`
    void into(const std::string& prefix, const std::string* bytes, int depth);

    /// Into an archive within the first one, or in the folder that is at the top. A broken one is as good as none.
    void within(const std::string& name, const std::string* bytes, int depth);

    Found found;

private:
    using Archive = std::unique_ptr<archive, int (*)(archive*)>;

    [[noreturn]] void fail(archive* in) const {
        const char* why = archive_error_string(in);
        throw SubmissionError(fmt::format("{}: cannot be unpacked: {}", shown_, what_is_wrong(ends(), why ? why : "")));
    }
    /// What has been found so far stands.
    void stop(const std::string& why) { found.unread = fs::path(shown_).filename().string() + " " + why; }
    bool is_stopped() const { return !found.unread.empty(); }
    Ends ends() const { return bytes_ ? ends_of(*bytes_) : ends_of(fs::path(shown_)); }
    void look_at(archive* in, archive_entry* entry, const std::string& name, int depth);
    void take(archive* in, const std::string& name);
    std::optional<std::string> read(archive* in, std::size_t most) const;

    const fs::path top_;
    std::string shown_;                   // which archive is looked into
    const std::string* bytes_ = nullptr;  // its own; none: it is a file
    const std::vector<std::string>& fragments_;
    const FrameworkFiles handed_out_;
    std::set<std::string> names_;
    std::int64_t unpacked_ = 0, taken_ = 0;
    int entries_ = 0;
};

/// The whole entry; none: it is larger.
std::optional<std::string> Look::read(archive* in, std::size_t most) const {
    std::string text;
    for (std::size_t have = 0;;) {
        text.resize(std::min(most + 1, have + (256u << 10)));
        const la_ssize_t got = archive_read_data(in, text.data() + have, text.size() - have);
        if (got < 0) fail(in);
        have += std::size_t(got);
        if (got == 0 || have > most) {
            text.resize(have);
            break;
        }
    }
    if (text.size() > most) return std::nullopt;
    text.shrink_to_fit();
    return text;
}

void Look::take(archive* in, const std::string& name) {
    std::optional<std::string> text = read(in, most_source_bytes);
    if (!text) {
        found.complaints[name] = too_large();
        return;
    }
    if ((taken_ += std::int64_t(text->size())) > most_taken)
        throw SubmissionError(
            fmt::format("{}: holds more than {} MiB in files that are named like fragments", shown_, most_taken >> 20));
    const auto [place, fresh] = found.texts.try_emplace(name, *text);
    if (!fresh && place->second != *text) found.doubled.insert(name);
    place->second = std::move(*text);
}

void Look::look_at(archive* in, archive_entry* entry, const std::string& name, int depth) {
    const bool is_file = archive_entry_filetype(entry) == AE_IFREG && !archive_entry_hardlink(entry);
    if (names_.contains(fs::path(name).filename().string())) {
        if (is_file)
            take(in, name);
        else
            found.complaints[name] = "not a regular file; links and devices are not followed";
        return;
    }
    if (is_file) found.look_at_name(name, fragments_);
    if (is_file && handed_out_.has(name)) {
        const auto text = read(in, most_source_bytes);
        if (!archive_entry_size_is_set(entry)) unpacked_ += std::int64_t(text ? text->size() : most_source_bytes);
        if (!text || handed_out_.differs(name, *text)) found.edited.insert(name);
    }
    // what is skipped is unpacked all the same
    if (archive_entry_size_is_set(entry)) unpacked_ += archive_entry_size(entry);
    if (unpacked_ > most_unpacked) stop(fmt::format("unpacks to more than {} MiB", most_unpacked >> 20));
    if (is_stopped() || !is_file || depth >= most_depth || !is_archive(name) || name.starts_with("__MACOSX")) return;
    const std::optional<std::string> bytes = read(in, std::size_t(most_inner));
    if (!bytes) return;
    if (!archive_entry_size_is_set(entry)) unpacked_ += std::int64_t(bytes->size());
    within(name, &*bytes, depth + 1);
}

void Look::within(const std::string& name, const std::string* bytes, int depth) {
    const std::string outer = std::exchange(shown_, (top_ / name).string());
    const std::string* outer_bytes = std::exchange(bytes_, bytes);
    try {
        into(name + "/", bytes, depth);
        // it has been looked into
        std::erase(found.archives, name);
    } catch (const SubmissionError& error) {
        if (is_stopped() || taken_ > most_taken) throw;
        if (found.broken.empty()) found.broken = error.what();
    }
    shown_ = outer, bytes_ = outer_bytes;
}

void Look::into(const std::string& prefix, const std::string* bytes, int depth) {
    const Archive in(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(in.get());
    archive_read_support_format_tar(in.get());
    archive_read_support_filter_gzip(in.get());
    const int opened = bytes ? archive_read_open_memory(in.get(), bytes->data(), bytes->size())
                             : archive_read_open_filename(in.get(), shown_.c_str(), 1 << 16);
    if (opened != ARCHIVE_OK) fail(in.get());
    for (; !is_stopped(); ++entries_) {
        archive_entry* entry = nullptr;
        const int status = archive_read_next_header(in.get(), &entry);
        if (status == ARCHIVE_EOF) {
            if (is_cut_zip(ends())) found.cut = fs::path(shown_).filename().string();
            return;
        }
        if (status < ARCHIVE_WARN) fail(in.get());
        if (entries_ >= most_entries) return stop(fmt::format("holds more than {} files", most_entries));
        const char* raw = archive_entry_pathname(entry);
        if (!raw) {
            ++found.unnamed;
            continue;
        }
        // the path is a name and nothing else: nothing is written to it
        const std::string name = plain_path(raw);
        if (name.starts_with("/") || name.starts_with("..")) {
            if (archive_entry_filetype(entry) == AE_IFREG && ++found.outside == 1)
                found.first_outside = name.substr(0, most_shown);
        } else {
            look_at(in.get(), entry, prefix + name, depth);
        }
    }
}

}  // namespace

Found look_into_archive(const fs::path& path, const std::vector<std::string>& fragments, const fs::path& framework) {
    const NamesInUtf8 names_in_utf8;
    Look look(path, fragments, framework);
    look.into("", nullptr, 0);
    return std::move(look.found);
}

void look_into_archives(const fs::path& folder, const std::vector<std::string>& fragments, const fs::path& framework,
                        Found& found) {
    const NamesInUtf8 names_in_utf8;
    Look look(folder, fragments, framework);
    look.found = std::move(found);
    const std::vector<std::string> names = look.found.archives;
    for (const std::string& name : names)
        if (is_archive(name) && look.found.unread.empty()) look.within(name, nullptr, 0);
    found = std::move(look.found);
}

}  // namespace grade
