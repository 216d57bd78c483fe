#pragma once

#include <array>
#include <string>
#include <string_view>

#include "record/record.h"

/// The record in the words of the systems that courses use: each format is a function of the record alone, in a file of
/// its own.
namespace grade {

/// Gradescope's results.json. Source: gradescope-autograders.readthedocs.io, "Autograder Specifications".
std::string gradescope(const Record& record);

/// PrairieLearn's results.json of an external grader. Source: docs.prairielearn.com/externalGrading, "Grading results".
std::string prairielearn(const Record& record);

/// JUnit's XML as Jenkins, GitLab and others read it: a suite for each fragment, a case for each check. Wrong is a
/// failure, a crash an error, a blank skipped; points are properties.
std::string junit(const Record& record);

/// Markdown for the summary of a step in GitHub Actions, less than its 1 MiB.
std::string actions(const Record& record);

/// Lines that GitHub Actions show beside the code: at most the 10 that a step may have.
std::string annotations(const Record& record);

/// Classroom 50's result.json, classroom50/result/v1. What tells whose result it is comes from the environment that its
/// runner sets. Source: github.com/foundation50/classroom50/wiki/Advanced-Autograding.
std::string classroom50(const Record& record);

/// Tables of a single row; classes have one row for each submission: tables.h.
std::string csv(const Record& record);
std::string canvas(const Record& record);
std::string moodle(const Record& record);

/// The page, without pictures: those are drawn when a submission is graded.
std::string html_page(const Record& record);

/// The table that `grade` prints.
std::string terminal(const Record& record);

struct Format {
    std::string_view name;
    std::string (*write)(const Record&);
};

constexpr std::array<Format, 11> formats{{{"gradescope", gradescope},
                                          {"prairielearn", prairielearn},
                                          {"junit", junit},
                                          {"actions", actions},
                                          {"annotations", annotations},
                                          {"classroom50", classroom50},
                                          {"csv", csv},
                                          {"canvas", canvas},
                                          {"moodle", moodle},
                                          {"html", html_page},
                                          {"terminal", terminal}}};

}  // namespace grade
