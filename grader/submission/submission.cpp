#include "submission/submission.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "files/files.h"
#include "submission/archive.h"
#include "submission/code_only.h"
#include "submission/framework.h"
#include "submission/near_name.h"

namespace grade {

namespace {

std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/') + 1); }

std::string in_words(const std::string& folder) { return folder.empty() ? "the top folder" : folder; }

/// A folder with fragments in it, and what speaks for it.
struct Place {
    std::string folder;
    int count = 0, filled = 0;  // fragments, and those that are no blanks
    bool set_aside = false;     // by its name or that of a folder around it
    bool named = false;         // fragments

    /// What makes it the one to take, and not the other; empty: nothing.
    std::string better_than(const Place& other) const {
        if (set_aside != other.set_aside)
            return set_aside ? "" : fmt::format("{} looks set aside by its name", other.folder);
        if (filled != other.filled) return filled < other.filled ? "" : more_in(other);
        if (count != other.count) return count < other.count ? "" : "it holds more fragments";
        if (named != other.named) return named ? "it is named fragments" : "";
        if (folder.size() != other.folder.size())
            return folder.size() < other.folder.size() ? "its path is shorter" : "";
        return folder < other.folder ? "its name comes first" : "";
    }

    /// Why more are filled in here.
    std::string more_in(const Place& other) const {
        return count > other.count ? "it holds more fragments" : "more of its fragments are filled in";
    }
};

/// The folders that hold fragments, the one to take first.
std::vector<Place> places_of(const Found& found) {
    std::map<std::string, Place> places;
    const auto count = [&](const std::string& path, bool filled) {
        const std::string folder = folder_of(path);
        if (folder.starts_with("__MACOSX")) return;  // what macOS adds to archives is no submission
        Place& place = places.try_emplace(folder, Place{folder}).first->second;
        ++place.count, place.filled += filled;
    };
    for (const auto& [path, text] : found.texts) count(path, !is_blank(text, {}));
    for (const auto& [path, complaint] : found.complaints) count(path, false);
    std::vector<Place> sorted;
    for (auto& [folder, place] : places) {
        for (const fs::path& part : fs::path(folder)) place.set_aside |= is_set_aside(part.string());
        place.named = folder == "fragments/" || folder.ends_with("/fragments/");
        sorted.push_back(place);
    }
    // an aside that all of them share says nothing
    if (std::ranges::all_of(sorted, &Place::set_aside))
        for (Place& place : sorted) place.set_aside = false;
    std::ranges::sort(sorted, [](const Place& a, const Place& b) { return !a.better_than(b).empty(); });
    return sorted;
}

/// Why a fragment that has no file of its name is missing, where another file may be meant; empty: none may be.
std::string nearest_to(const std::string& fragment, const std::string& folder, const Found& found) {
    const std::string file = fragment + ".cpp";
    std::string best;
    int best_rank = 4;
    const auto consider = [&](const std::string& path, int rank) {
        if (path.starts_with("__MACOSX") || rank >= best_rank) return;
        best = path, best_rank = rank;
    };
    for (const auto& [path, meant] : found.near)
        if (meant == fragment) consider(path, folder_of(path) == folder ? 0 : 2);
    for (const auto& [path, text] : found.texts)
        if (path.ends_with("/" + file) || path == file) consider(path, 1);
    if (best.empty()) return {};
    if (best_rank == 1) return fmt::format("not in {}; there is {}: put it there", in_words(folder), best);
    return fmt::format("not in the submission; there is {}: rename it to {}", best,
                       folder_of(best) == folder ? file : folder + file);
}

/// Of names such as "../phong.cpp".
std::string leads_out(const Found& found) {
    return fmt::format("{} {} out of the archive", found.first_outside,
                       found.outside > 1 ? "and others lead" : "leads");
}

/// What is told of a submission with several files for one fragment.
void note_copies(const std::vector<Place>& places, const Found& found, Submission& submission) {
    for (const std::string& path : found.doubled)
        if (folder_of(path) == submission.folder)
            submission.notes.push_back(fmt::format(
                "{} is in the archive twice, with different texts; the later one was taken, as by unpacking", path));
    for (std::size_t i = 1; i < places.size(); ++i) {
        const auto copies = [&](const std::string& fragment) {
            const std::string file = fragment + ".cpp";
            return found.texts.contains(places[i].folder + file) && found.texts.contains(submission.folder + file);
        };
        std::vector<std::string> names;
        for (const auto& [fragment, text] : submission.texts)
            if (copies(fragment)) names.push_back(fragment + ".cpp");
        if (names.empty()) continue;
        const std::string which = names.size() > 3
                                      ? fmt::format("{} fragments are", names.size())
                                      : fmt::format("{} {}", fmt::join(names, ", "), names.size() == 1 ? "is" : "are");
        submission.notes.push_back(fmt::format("{} in {} and in {}; what is in {} was taken: {}", which,
                                               in_words(submission.folder), in_words(places[i].folder),
                                               in_words(submission.folder), places[0].better_than(places[i])));
    }
    for (const auto& [path, fragment] : found.near)
        if (path.ends_with(".cpp") && submission.texts.contains(fragment) && folder_of(path) == submission.folder)
            submission.notes.push_back(fmt::format("{} was left out: {}.cpp is there as well", path, fragment));
    for (const std::string& path : found.archives)
        if (!submission.texts.empty() && folder_of(path) == submission.folder)
            submission.notes.push_back(fmt::format(
                "{} was left out: {}", path,
                found.broken.find(path) != found.broken.npos ? found.broken : "there are fragments beside it"));
    for (const std::string& path : found.archives)
        if (submission.folder.starts_with(path + "/"))
            submission.notes.push_back(path + " was read in part: it is cut off or broken");
    if (!found.unread.empty())
        submission.notes.push_back(found.unread + "; what was read until then was taken; expected fragments/ alone");
    if (!found.cut.empty())
        submission.notes.push_back(found.cut + ": it is cut off, its end is missing; what could be read was taken");
    if (found.outside > 0)
        submission.notes.push_back(fmt::format("{} file{} left out: {}", found.outside,
                                               found.outside > 1 ? "s were" : " was", leads_out(found)));
    if (found.unnamed > 0)
        submission.notes.push_back(fmt::format("{} files were left out: their names cannot be read", found.unnamed));
}

/// Tells of edits of the framework beside the fragments that were taken.
void note_edits(const std::vector<std::string>& edited, Submission& submission) {
    if (edited.empty()) return;
    const std::string more = edited.size() > 1 ? fmt::format(" and {} more", edited.size() - 1) : "";
    submission.notes.push_back(fmt::format(
        "{}{}: not as they were handed out; edits of the framework are ignored, the fragments alone are taken",
        edited.front(), more));
}

/// The folder whose fragments/ holds the fragments that were taken.
std::string around(const std::string& folder) {
    return folder.ends_with("fragments/") ? folder.substr(0, folder.size() - std::size("fragments/") + 1) : folder;
}

std::string no_fragment(const fs::path& path, const Found& found, const std::vector<std::string>& fragments) {
    const std::string expected =
        fmt::format("expected files such as fragments/{}.cpp", fragments.empty() ? "NAME" : fragments.front());
    if (!found.unread.empty())
        return fmt::format("{}: holds no fragment; {}, and the rest was not read; {} alone", path.string(),
                           found.unread, expected);
    if (!found.cut.empty())
        return fmt::format(
            "{}: holds no fragment; {} is cut off, its end is missing; expected all of it, uploaded again",
            path.string(), found.cut);
    if (!found.broken.empty()) return fmt::format("{}: holds no fragment; {}", path.string(), found.broken);
    if (!found.archives.empty())
        return fmt::format("{}: holds no fragment, but another archive, {}: unpack it; {}", path.string(),
                           found.archives.front(), expected);
    if (found.outside > 0)
        return fmt::format("{}: holds nothing that can be taken: {}; {}", path.string(), leads_out(found), expected);
    if (found.unnamed > 0)
        return fmt::format("{}: holds no fragment whose name can be read; {}", path.string(), expected);
    return fmt::format("{}: holds no fragment; {}", path.string(), expected);
}

}  // namespace

void note_given(Submission& submission, const std::set<std::string>& asked, const fs::path& blanks) {
    for (const auto& [fragment, text] : submission.texts) {
        if (asked.contains(fragment)) continue;
        const auto given = read_text(blanks / (fragment + ".cpp"));
        if (given && code_only(*given) != code_only(text))
            submission.notes.push_back(
                fmt::format("{}{}.cpp: handed out filled in, and changed; it is not graded, and gradings use the one "
                            "that was handed out",
                            submission.folder, fragment));
    }
}

Submission read_submission(const fs::path& path, const std::vector<std::string>& fragments, const fs::path& framework) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status))
        throw SubmissionError(fmt::format("{}: not there; expected a folder, a .zip or a .tar.gz", path.string()));
    const bool in_archive = !fs::is_directory(status);
    if (in_archive && !fs::is_regular_file(status))
        throw SubmissionError(
            fmt::format("{}: is neither a file nor a folder; expected a folder, a .zip or a .tar.gz", path.string()));
    const Found found =
        in_archive ? look_into_archive(path, fragments, framework) : look_into_folder(path, fragments, framework);

    Submission submission;
    submission.name = path.string();
    const std::vector<Place> places = places_of(found);
    submission.folder = places.empty() ? "" : places[0].folder;
    for (const std::string& fragment : fragments) {
        const std::string file = submission.folder + fragment + ".cpp";
        if (const auto text = found.texts.find(file); text != found.texts.end())
            submission.texts[fragment] = text->second;
        if (const auto complaint = found.complaints.find(file); complaint != found.complaints.end())
            submission.complaints[fragment] = complaint->second;
        else if (const std::string near = nearest_to(fragment, submission.folder, found);
                 !near.empty() && !submission.texts.contains(fragment))
            submission.complaints[fragment] = near;
    }
    if (submission.texts.empty() && submission.complaints.empty())
        throw SubmissionError(no_fragment(path, found, fragments));
    note_copies(places, found, submission);
    const std::string within = around(submission.folder);
    std::vector<std::string> edited;
    for (const std::string& file : found.edited)
        if (file.starts_with(within + "rt/")) edited.push_back(file);
    if (!in_archive && edited.empty()) edited = FrameworkFiles(framework).edited_in(path, within);
    note_edits(edited, submission);
    return submission;
}

}  // namespace grade
