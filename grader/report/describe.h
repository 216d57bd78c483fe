#pragma once

#include <string>

#include "assignment/assignment.h"

/// What the handout says about points and checks, written by the program that gives the points.
namespace grade {

/// A table of the parts, their fragments and points.
std::string describe_points(const Assignment& assignment);

/// One fragment's points and checks: what each measures, what must come out, and how far off it may be. Numbers that
/// depend on the grading seed are words. A fragment that the assignment leaves out is handed out filled in.
std::string describe_checks(const Assignment& assignment, const std::string& fragment);

/// The handout with its blocks made anew, each between its markers:
///
///     <!-- points -->           ... <!-- end -->
///     <!-- checks: FRAGMENT --> ... <!-- end -->
///     <!-- keys: TABLE -->      ... <!-- end -->    of scene files; "file": those that are in no table
///     <!-- count -->32<!-- end -->    how many fragments students fill in, within a line
///
/// path is for errors: throws rt::InputError for a marker without end and for an unknown fragment or table.
std::string with_new_tables(const std::string& handout, const Assignment& assignment, const std::string& path);

/// The same as it is handed out: without the sections of fragments that the assignment leaves out. Where a part has
/// none left, its heading stays, for links, and says so.
std::string handed_out(const std::string& handout, const Assignment& assignment, const std::string& path);

}  // namespace grade
