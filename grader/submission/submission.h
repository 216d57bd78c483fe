#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "rt/files/scene_reader.h"

namespace grade {

namespace fs = std::filesystem;

/// What is taken from a submission: the text of each fragment that is there. Everything else in it is ignored.
struct Submission {
    std::string name;                               // as it was given
    std::map<std::string, std::string> texts;       // by fragment
    std::map<std::string, std::string> complaints;  // by fragment: why its file was not taken
    std::vector<std::string> notes;                 // on what was taken of several copies
    std::string folder;                             // where the fragments were, within it: "fragments/"; may be empty
};

/// What is wrong with a submission as a whole.
struct SubmissionError : rt::InputError {
    using InputError::InputError;
};

/// Largest source file that is taken.
constexpr std::uint64_t most_source_bytes = 256u << 10;

/// Reads a folder, a .zip or a .tar.gz, with the fragments in fragments/, directly in it, or in another of its folders:
/// of several, one is taken, and a note says which and why. Where a fragment is missing and another file's name is near
/// to its own, the complaint names that file. Links are not followed. Archives within an archive are looked into, and
/// those in a folder. framework: the folder of its rt/, with which copies in the submission are compared; a note says
/// which are edited. Throws SubmissionError.
Submission read_submission(const fs::path& path, const std::vector<std::string>& fragments,
                           const fs::path& framework = {});

/// Adds a note for what was taken of fragments that are handed out filled in, and is not as it was handed out.
///
/// asked   the fragments that are not
/// blanks  the folder of what is handed out
void note_given(Submission& submission, const std::set<std::string>& asked, const fs::path& blanks);

}  // namespace grade
