#include "class/entries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "files/files.h"
#include "rt/files/scene_reader.h"

namespace grade::course {

namespace {

constexpr std::size_t most_entries = 20'000, most_loose = 200;

enum class Kind { folder, archive, source };

/// A file or folder at the top of the export.
struct Item {
    fs::path path;
    Student student;
    Kind kind = Kind::folder;
};

bool is_archive(const std::string& name) {
    return std::ranges::any_of(std::array{".zip", ".tar", ".tar.gz", ".tgz"},
                               [&](const char* ending) { return name.ends_with(ending); });
}

/// A copy of a source is one too: "phong-1.cpp", "phong.cpp.txt".
bool is_source(const std::string& name) { return name.find(".cpp") != name.npos || name.ends_with(".cc"); }

std::vector<Item> items_of(const fs::path& folder) {
    std::vector<Item> items;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (name.starts_with(".") || name.starts_with("__MACOSX")) continue;
        const fs::file_type type = at->symlink_status(error).type();
        Item item{at->path(), student_of(name), Kind::folder};
        if (type == fs::file_type::regular && is_archive(name))
            item.kind = Kind::archive;
        else if (type == fs::file_type::regular && is_source(name))
            item.kind = Kind::source;
        else if (type != fs::file_type::directory)
            continue;
        items.push_back(std::move(item));
        if (items.size() > most_entries)
            throw rt::InputError(fmt::format("{}: more than {} files; expected the submissions of a class",
                                             folder.string(), most_entries));
    }
    if (error) throw rt::InputError(fmt::format("{}: {}; expected a folder", folder.string(), error.message()));
    std::ranges::sort(items, {}, [](const Item& item) { return item.path.filename().string(); });
    return items;
}

/// The later of two of one student: by the time of the attempt, by the number of the copy, by name.
bool is_later(const Item& a, const Item& b) {
    const auto rank = [](const Item& item) {
        return std::tuple(item.student.attempt, copy_of(item.student.file), item.path.filename().string());
    };
    return rank(a) > rank(b);
}

/// The words without the place of the file, which is another one elsewhere.
std::string without_place(std::string words, const std::string& place, const std::string& name) {
    for (std::size_t at = 0; (at = words.find(place, at)) != words.npos; at += name.size())
        words.replace(at, place.size(), name);
    return words;
}

/// Loose files of one student, in a folder of their own under the names that the student gave them.
Submission read_loose(const std::vector<Item>& items, const std::vector<std::string>& fragments) {
    const TemporaryFolder folder;
    std::size_t count = 0;
    for (const Item& item : items) {
        if (++count > most_loose) break;
        const std::string name =
            fs::path(item.student.file.empty() ? item.path.filename().string() : item.student.file).filename().string();
        if (const auto text = read_text(item.path, 4 * most_source_bytes)) write_text(folder.path() / name, *text);
    }
    try {
        return read_submission(folder.path(), fragments);
    } catch (const SubmissionError& error) {
        throw SubmissionError(without_place(error.what(), folder.path().string(), items.front().path.string()));
    }
}

Entry entry_of(std::vector<Item> items, const std::vector<std::string>& fragments, const fs::path& framework) {
    std::ranges::sort(items, is_later);
    // an archive or a folder is the work; loose files are, where there is neither
    const auto whole = std::ranges::find_if(items, [](const Item& item) { return item.kind != Kind::source; });
    Entry entry;
    const Item& taken = whole == items.end() ? items.front() : *whole;
    entry.student = taken.student, entry.path = taken.path.filename().string();
    for (const Item& item : items) entry.student.is_late |= item.student.is_late;
    try {
        if (whole != items.end()) {
            entry.submission = read_submission(taken.path, fragments, framework);
            std::vector<std::string> others;
            for (const Item& item : items)
                if (&item != &taken) others.push_back(item.path.filename().string());
            if (!others.empty())
                entry.notes.push_back(
                    fmt::format("{} was taken, the latest; not {}", entry.path, fmt::join(others, ", ")));
        } else {
            const std::string attempt = taken.student.attempt;
            std::erase_if(items, [&](const Item& item) { return item.student.attempt != attempt; });
            entry.submission = read_loose(items, fragments);
        }
    } catch (const SubmissionError& error) {
        entry.fault = without_place(error.what(), taken.path.string(), entry.path);
    }
    entry.submission.name = entry.path;
    return entry;
}

/// What all repositories of an assignment begin with: "hw1-" of "hw1-alice", "hw1-bob"; empty: nothing.
std::string common_start(const std::vector<Entry>& entries) {
    std::string start;
    int count = 0;
    for (const Entry& entry : entries) {
        if (!entry.student.system.empty()) continue;
        const std::string& name = entry.student.name;
        if (++count == 1) start = name;
        start.resize(std::size_t(std::ranges::mismatch(start, name).in1 - start.begin()));
    }
    const std::size_t dash = start.rfind('-');
    return count < 3 || dash == start.npos ? "" : start.substr(0, dash + 1);
}

/// Names and numbers from Gradescope's submission_metadata.yml, of which only these lines are read:
///
///     submission_123:
///       :submitters:
///       - :name: Jane Doe
///         :sid: '4711'
void add_gradescope_names(const fs::path& folder, std::vector<Entry>& entries) {
    const auto text = read_text(folder / "submission_metadata.yml", 64u << 20);
    if (!text) return;
    std::istringstream lines(*text);
    Entry* entry = nullptr;
    const auto value_of = [](const std::string& line, const char* key) -> std::string {
        const std::size_t at = line.find(key);
        if (at == line.npos || line.find_first_not_of(" -") != at) return {};
        std::string value = line.substr(at + std::string_view(key).size());
        const std::size_t begin = value.find_first_not_of(' '), end = value.find_last_not_of(" \r");
        if (begin == value.npos) return {};
        value = value.substr(begin, end - begin + 1);
        const bool quoted = value.size() > 1 && value.front() == value.back() &&
                            std::string_view("'\"").find(value[0]) != std::string_view::npos;
        return quoted ? value.substr(1, value.size() - 2) : value;
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

std::vector<Entry> read_export(const fs::path& folder, const Assignment& assignment, const fs::path& framework) {
    std::error_code error;
    if (!fs::is_directory(folder, error))
        throw rt::InputError(
            fmt::format("{}: not there; expected a folder of submissions: folders, archives, or files "
                        "as a course system exports them, unpacked",
                        folder.string()));
    const std::vector<std::string> names = assignment.names();
    std::map<std::string, std::vector<Item>> by_student;
    for (Item& item : items_of(folder)) by_student[item.student.key()].push_back(std::move(item));
    std::vector<Entry> entries;
    for (auto& [key, items] : by_student) entries.push_back(entry_of(std::move(items), names, framework));
    if (entries.empty())
        throw rt::InputError(
            fmt::format("{}: holds no submission; expected folders, archives, or files", folder.string()));
    std::ranges::sort(entries, {}, &Entry::path);
    add_gradescope_names(folder, entries);
    const std::string start = common_start(entries);
    for (Entry& entry : entries)
        if (entry.student.system.empty()) entry.student.name.erase(0, start.size());
    return entries;
}

}  // namespace grade::course
