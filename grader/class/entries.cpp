#include "class/entries.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "class/gradescope_names.h"
#include "files/files.h"
#include "rt/files/scene_reader.h"
#include "submission/archive.h"

namespace grade::course {

namespace {

constexpr std::size_t most_entries = 20'000, most_loose = 200;

/// typed: into a form of Moodle's; link: or a device; other: an essay, an archive of another kind, ...
enum class Kind { folder, archive, source, typed, link, other };

/// A file or folder at the top of the export.
struct Item {
    fs::path path;
    Student student;
    Kind kind = Kind::folder;
};

/// A copy of a source is one too: "phong-1.cpp", "phong.cpp.txt".
bool is_source(const std::string& name) { return name.find(".cpp") != name.npos || name.ends_with(".cc"); }

bool is_work(const Item& item) {
    return item.kind == Kind::folder || item.kind == Kind::archive || item.kind == Kind::source;
}

Kind kind_of_item(const std::string& name, fs::file_type type) {
    if (type == fs::file_type::directory)
        return name.find("_assignsubmission_onlinetext") == name.npos ? Kind::folder : Kind::typed;
    if (type != fs::file_type::regular) return Kind::link;
    return is_archive(name) ? Kind::archive : is_source(name) ? Kind::source : Kind::other;
}

/// Files that are there beside the submissions.
bool is_beside(const std::string& name) {
    return name.starts_with(".") || name.starts_with("__MACOSX") || name == "submission_metadata.yml" ||
           name == "Thumbs.db" || name == "desktop.ini" || name.ends_with(".csv");
}

std::vector<Item> items_of(const fs::path& folder) {
    std::vector<Item> items;
    std::error_code error;
    for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
        const std::string name = at->path().filename().string();
        if (is_beside(name)) continue;
        items.push_back({at->path(), student_of(name), kind_of_item(name, at->symlink_status(error).type())});
        if (items.size() > most_entries)
            throw rt::InputError(fmt::format("{}: more than {} files; expected the submissions of a class",
                                             folder.string(), most_entries));
    }
    if (error) throw rt::InputError(fmt::format("{}: {}; expected a folder", folder.string(), error.message()));
    std::ranges::sort(items, {}, [](const Item& item) { return item.path.filename().string(); });
    return items;
}

/// The later of two of one student: by the time of the attempt, by the number of the upload, by that of the copy, by
/// name.
bool is_later(const Item& a, const Item& b) {
    const auto rank = [](const Item& item) {
        const Student& student = item.student;
        return std::tuple(student.attempt, student.upload.size(), student.upload, copy_of(student.file),
                          item.path.filename().string());
    };
    return rank(a) > rank(b);
}

/// The words without the place of the file, which is another one elsewhere.
std::string without_place(std::string words, const std::string& place, const std::string& name) {
    for (std::size_t at = 0; (at = words.find(place, at)) != words.npos; at += name.size())
        words.replace(at, place.size(), name);
    return words;
}

/// The name that the student gave a loose file: that of a fragment without the number of a copy.
std::string own_name(const Item& item, const std::vector<std::string>& fragments) {
    const std::string name = item.student.file.empty() ? item.path.filename().string() : item.student.file;
    if (copy_of(name) == 0) return name;
    std::string fragment = name.substr(0, name.find_last_of("-("));
    fragment.resize(fragment.find_last_not_of(' ') + 1);
    return std::ranges::count(fragments, fragment) > 0 ? fragment + ".cpp" : name;
}

/// Loose files of one student, the latest first, in a folder of their own under the names that the student gave them.
Submission read_loose(const std::vector<Item>& items, const std::vector<std::string>& fragments,
                      std::vector<std::string>& notes) {
    const TemporaryFolder folder;
    std::map<std::string, std::string> taken;
    for (const Item& item : items) {
        const std::string name = own_name(item, fragments), file = item.path.filename().string();
        if (taken.size() == most_loose) {
            notes.push_back(fmt::format("{} and more were left out; expected at most {} files", file, most_loose));
            break;
        }
        const auto [place, fresh] = taken.try_emplace(name, file);
        if (!fresh)
            notes.push_back(fmt::format("{} was taken, the latest; not {}", place->second, file));
        else if (const auto text = read_text(item.path, 4 * most_source_bytes))
            write_text(folder.path() / name, *text);
        else
            notes.push_back(fmt::format("{} was left out: it cannot be read, or is too large", file));
    }
    try {
        return read_submission(folder.path(), fragments);
    } catch (const SubmissionError& error) {
        throw SubmissionError(without_place(error.what(), folder.path().string(), items.front().path.string()));
    }
}

/// Why there is nothing to read, of what is no work.
std::string not_work(const Item& item, const std::vector<std::string>& fragments) {
    const std::string name = item.path.filename().string();
    if (item.kind == Kind::link)
        return name + ": is a link or a device, which is not followed; expected the file itself";
    return fmt::format("{}: is {}; expected a .zip, a .tar.gz, or files such as {}.cpp", name,
                       item.kind == Kind::typed ? "text that was typed into Moodle" : "neither source nor an archive",
                       fragments.empty() ? "NAME" : fragments.front());
}

/// The place of what is taken, of the latest first: an archive or a folder is the work; loose files are, where there is
/// neither.
std::size_t place_of_work(const std::vector<Item>& items) {
    for (const bool loose : {false, true})
        for (std::size_t i = 0; i < items.size(); ++i)
            if (is_work(items[i]) && (items[i].kind == Kind::source) == loose) return i;
    return 0;
}

Entry entry_of(std::vector<Item> items, const std::vector<std::string>& fragments, const fs::path& framework) {
    std::ranges::sort(items, is_later);
    const Item taken = items[place_of_work(items)];
    const bool loose = taken.kind == Kind::source;
    Entry entry;
    entry.student = taken.student, entry.path = taken.path.filename().string(), entry.is_work = is_work(taken);
    std::vector<std::string> others;
    for (const Item& item : items) {
        entry.student.is_late |= item.student.is_late;
        const bool together = loose && item.kind == Kind::source && item.student.attempt == taken.student.attempt;
        if (item.path != taken.path && !together && (is_work(item) || item.kind == Kind::link))
            others.push_back(item.path.filename().string());
    }
    if (!others.empty())
        entry.notes.push_back(fmt::format("{} was taken{}; not {}", entry.path, entry.is_work ? ", the latest" : "",
                                          fmt::join(others, ", ")));
    try {
        if (!entry.is_work) throw SubmissionError(not_work(taken, fragments));
        if (loose) {
            std::erase_if(items, [&](const Item& item) {
                return item.kind != Kind::source || item.student.attempt != taken.student.attempt;
            });
            entry.submission = read_loose(items, fragments, entry.notes);
        } else {
            entry.submission = read_submission(taken.path, fragments, framework);
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
        if (!entry.student.system.empty() || !entry.is_work) continue;
        const std::string& name = entry.student.name;
        if (++count == 1) start = name;
        start.resize(std::size_t(std::ranges::mismatch(start, name).in1 - start.begin()));
    }
    const std::size_t dash = start.rfind('-');
    return count < 3 || dash == start.npos ? "" : start.substr(0, dash + 1);
}

}  // namespace

std::vector<Entry> read_export(const fs::path& folder, const Assignment& assignment, const fs::path& framework) {
    std::error_code error;
    if (fs::is_regular_file(folder, error))
        throw rt::InputError(fmt::format(
            "{}: is a file; expected a folder of submissions: an export of a course system is unpacked once",
            folder.string()));
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
    const bool are_of_one = entries.size() > 1 && std::ranges::all_of(entries, [&](const Entry& entry) {
                                return std::ranges::count(names, fs::path(entry.path).stem().string()) > 0;
                            });
    if (are_of_one)
        throw rt::InputError(
            fmt::format("{}: holds fragments by their own names, as one submission does; expected the "
                        "folder above it, which holds the submissions",
                        folder.string()));
    std::ranges::sort(entries, {}, &Entry::path);
    add_gradescope_names(folder, entries);
    const std::string start = common_start(entries);
    for (Entry& entry : entries)
        if (entry.student.system.empty() && entry.student.name.starts_with(start))
            entry.student.name.erase(0, start.size());
    return entries;
}

}  // namespace grade::course
