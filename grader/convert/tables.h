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

/// What Canvas's gradebook imports: its students by their ID, and the points of one assignment. Empty: no name holds an
/// ID of Canvas's; another system's number would be another student's.
std::string canvas_table(std::vector<TableRow> rows);

/// What Moodle's "upload grading worksheet" imports: its participants by their number. Empty: as above.
std::string moodle_table(std::vector<TableRow> rows);

}  // namespace grade
