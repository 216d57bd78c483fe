#include "class/grading.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <map>
#include <mutex>

#include "files/files.h"
#include "programs/parallel.h"
#include "report/json.h"
#include "report/terminal.h"
#include "submission/code_only.h"

namespace grade::course {

namespace {

constexpr int most_troubles = 3;  // in a row
constexpr std::size_t most_complaints = 5;

/// Drafts of records that a killed call has left.
void sweep(const fs::path& records) {
    std::error_code error;
    const auto old = fs::file_time_type::clock::now() - std::chrono::minutes(10);
    for (fs::directory_iterator at(records, error), end; !error && at != end; at.increment(error))
        if (at->path().extension() == ".tmp" && fs::last_write_time(at->path(), error) < old)
            fs::remove(at->path(), error);
}

/// By record: the first entry that it is for, of those that are this shard's and not graded yet.
std::map<std::string, const Entry*> open_ones(const std::vector<Entry>& entries, const std::vector<Result>& results,
                                              const ClassSettings& settings, const fs::path& out, int& before) {
    std::map<std::string, const Entry*> all, open;
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (!results[i].key.empty()) all.try_emplace(results[i].key, &entries[i]);
    int place = 0;
    for (const auto& [key, entry] : all) {
        if (place++ % settings.shard.all != settings.shard.which) continue;
        if (find_record(out, {.path = entry->path, .key = key}) &&
            (!settings.grading.pictures || fs::exists(pictures_file(out, key))))
            ++before;
        else
            open.emplace(key, entry);
    }
    return open;
}

/// What the record tells of each fragment, for the tables as well: what was not taken, and why.
void note_complaints(const Submission& submission, std::vector<std::string>& notes) {
    std::size_t left = submission.complaints.size();
    for (const auto& [fragment, complaint] : submission.complaints) {
        if (submission.complaints.size() - left == most_complaints) break;
        notes.push_back(fmt::format("{}: {}", fragment, complaint)), --left;
    }
    if (left > 0) notes.push_back(fmt::format("{} more fragments were not taken either; see the record", left));
}

}  // namespace

std::vector<Result> results_of(const std::vector<Entry>& entries, const Assignment& assignment, const Toolchain& chain,
                               const GradingSettings& settings) {
    std::vector<Result> results;
    for (const Entry& entry : entries) {
        Result result{entry.student, entry.path, entry.fault, entry.notes, "", {}, {}};
        Submission taken = entry.submission;
        note_given(taken, assignment.asked(), chain.blanks);
        result.notes.insert(result.notes.end(), taken.notes.begin(), taken.notes.end());
        note_complaints(entry.submission, result.notes);
        if (entry.fault.empty()) result.key = key_of(entry.submission, assignment, settings);
        for (const auto& [fragment, text] : entry.submission.texts)
            if (!is_blank(text, chain.blanks / (fragment + ".cpp"))) result.prints[fragment] = fingerprint(text);
        results.push_back(std::move(result));
    }
    return results;
}

Outcome grade_all(const std::vector<Entry>& entries, const std::vector<Result>& results, const Assignment& assignment,
                  const Toolchain& chain, const ClassSettings& settings, const fs::path& out) {
    sweep(out / "records");
    Outcome outcome;
    const auto open = open_ones(entries, results, settings, out, outcome.before);
    if (open.empty()) return outcome;
    const std::vector<std::pair<std::string, const Entry*>> list(open.begin(), open.end());
    const FutureChecks checks = ready(all_checks(settings.grading.seed));
    ProgressLine line(true);
    std::mutex lock;
    int in_a_row = 0;
    std::vector<std::string> left;  // when nothing went well any more
    line.show(0, int(list.size()), counted(list.size()));
    in_parallel(int(list.size()), settings.jobs, [&](int i) {
        const auto& [key, entry] = list[std::size_t(i)];
        {
            const std::scoped_lock guard(lock);
            if (in_a_row >= most_troubles) return left.push_back(entry->path);
        }
        try {
            Submission submission = entry->submission;
            submission.name.clear();  // the record is one of texts, whosever they are
            Record record = grade_submission(submission, assignment, chain, checks, settings.grading);
            if (settings.grading.pictures) write_pictures(out, key, record);
            const auto is_there = [&out = out, path = entry->path, name = key] {
                return find_record(out, {.path = path, .key = name}).has_value();
            };
            // one that is there stays as it is: it lacked pictures
            if (!is_there()) write_text(record_file(out, key), to_json(record));
            if (!is_there()) throw std::runtime_error(record_file(out, key).string() + ": is no whole record");
            const std::scoped_lock guard(lock);
            ++outcome.graded, in_a_row = 0;
        } catch (const std::exception& error) {
            const std::scoped_lock guard(lock);
            ++in_a_row, outcome.troubles.push_back(fmt::format("{}: {}", entry->path, error.what()));
        }
        const std::scoped_lock guard(lock);
        line.show(outcome.graded + int(outcome.troubles.size()), int(list.size()), entry->path);
    });
    if (!left.empty()) outcome.troubles.push_back(fmt::format("{}: nothing went well any more", fmt::join(left, ", ")));
    return outcome;
}

}  // namespace grade::course
