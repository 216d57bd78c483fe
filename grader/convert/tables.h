#pragma once

#include <string>
#include <vector>

#include "convert/student.h"
#include "record/record.h"

/// Tables of a class, a row for each submission, as CSV: RFC 4180.
namespace grade {

struct TableRow {
    Student student;
    const Record* record = nullptr;  // none: it could not be graded
    std::string fault;               // why
};

/// A cell: quoted where that is needed, and never a formula of a spreadsheet's.
std::string cell_of_csv(const std::string& text);

/// Everything: a column for each fragment, seed and hash included.
std::string csv_table(const std::vector<TableRow>& rows);

/// What Canvas's gradebook imports: students by their ID, and the points of one assignment.
std::string canvas_table(const std::vector<TableRow>& rows);

/// What Moodle's "upload grading worksheet" imports: participants by their number.
std::string moodle_table(const std::vector<TableRow>& rows);

}  // namespace grade
