#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assignment/assignment.h"
#include "convert/student.h"
#include "submission/submission.h"

namespace grade::course {

namespace fs = std::filesystem;

/// One student's submission in an export: what it is, and what was taken from it.
struct Entry {
    Student student;
    std::string path;                // of the folder, archive, or latest file, within the export
    Submission submission;           // empty where there is a fault
    std::string fault;               // why it cannot be graded; empty: it can
    std::vector<std::string> notes;  // beside the submission's own: of several files of one student, which was taken
    bool is_work = true;             // false: neither a folder, nor an archive, nor source text
};

/// Every submission of a folder as course systems export them (convert/student.h), in the order of their names:
/// folders, archives, and loose files NAME.cpp of one student. Of several by one student, or of one fragment, the
/// latest is taken: by the time of an attempt, the number of the upload or of a copy. What cannot be read is an entry
/// with a fault. framework: as for read_submission. Throws rt::InputError where the folder is none or holds no
/// submission.
std::vector<Entry> read_export(const fs::path& folder, const Assignment& assignment, const fs::path& framework);

}  // namespace grade::course
