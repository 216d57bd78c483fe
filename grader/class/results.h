#pragma once

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "class/entries.h"
#include "class/fingerprint.h"
#include "judging/grading.h"
#include "record/record.h"

namespace grade::course {

/// One row of a class: a student, and the record of the texts, which students with the same texts share.
struct Result {
    Student student;
    std::string path, fault;                    // as an entry has them
    std::vector<std::string> notes;             // on the submission
    std::string key;                            // names the record; empty: there is none
    std::map<std::string, Fingerprint> prints;  // by fragment: of those that are no blanks
    std::optional<Record> record;               // none: not graded, or not yet
};

/// It can be graded, and is not.
inline bool is_open(const Result& result) { return !result.record && result.fault.empty(); }

/// Whether anybody's name is one of this system.
inline bool has_any(const std::vector<Result>& results, const char* system) {
    return std::ranges::any_of(results, [=](const Result& result) { return result.student.system == system; });
}

/// "1 submission", "2 submissions".
std::string counted(std::size_t submissions);

/// The name of a submission's record: a hash of its texts and of what it is graded with, which are seed, provenance and
/// time limit.
std::string key_of(const Submission& submission, const Assignment& assignment, const GradingSettings& settings);

/// OUT/records/KEY.json
fs::path record_file(const fs::path& out, const std::string& key);

/// OUT/records/KEY.pictures: those of its page, as JSON.
fs::path pictures_file(const fs::path& out, const std::string& key);
void write_pictures(const fs::path& out, const std::string& key, const Record& record);

/// Writes the list of results: OUT/class.json.
void write_list(const fs::path& out, const std::vector<Result>& results, const std::string& title);

/// The list of a graded class with its records, as far as they are there. Throws rt::InputError where it is none.
std::vector<Result> read_list(const fs::path& out);

/// Reads the record under its key, if it is there and whole, with its pictures if they are there.
std::optional<Record> find_record(const fs::path& out, const Result& result);

}  // namespace grade::course
