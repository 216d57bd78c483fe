#pragma once

#include <string>
#include <string_view>

namespace grade {

/// What the name of a file or folder says about who handed it in, as course systems name what they export:
///
///     doejane_12345_67890_work.zip, doejane_LATE_12345_67890_work-1.zip     Canvas
///     Jane Doe_12345_assignsubmission_file_                                 Moodle
///     Assignment 1_jdoe_attempt_2026-01-31-12-00-00_work.zip                Blackboard
///     submission_12345                                                      Gradescope
///     anything else                                                         folders, repositories
struct Student {
    std::string name;     // shown: "doejane", "Jane Doe", "jdoe"
    std::string id;       // the system's, by which it takes grades back; empty: it has none
    std::string system;   // "Canvas", ...; empty: none of these
    std::string attempt;  // Blackboard's time of it; empty: none
    std::string file;     // what is left of the name: "work-1.zip"
    bool is_late = false;
    std::string upload;  // Canvas's number of the file, larger for later ones; empty: none

    /// Two entries of an export with the same key are one student's.
    std::string key() const { return id.empty() ? name : system + " " + id; }
};

/// Of a name without folders.
Student student_of(std::string_view name);

/// The number of a copy, as browsers and Canvas add it: 1 for "work-1.zip", "work (1).zip", "phong-1.cpp"; 0: none.
int copy_of(std::string_view file);

/// The name without what archives end in.
std::string without_ending(std::string_view name);

}  // namespace grade
