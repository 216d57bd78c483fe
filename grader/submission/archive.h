#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "submission/submission.h"

namespace grade {

/// A submission's files by path, those that could be fragments: FRAGMENT.cpp in any folder.
struct Found {
    std::map<std::string, std::string> texts, complaints;
    std::map<std::string, std::string> near;  // by path: the fragment that this file, by its name, is nearly
    std::set<std::string> doubled;      // paths that are there twice, with different texts: the later one is taken
    std::vector<std::string> archives;  // within the submission, that have not been looked into
    std::string broken;                 // what is wrong with the first of them; empty: nothing was found to be
    std::string unread;                 // why the rest of the archives was not read: they are too large; empty: it was
    std::string cut;                    // an archive whose end is missing, and of which the rest was read
    int unnamed = 0;                    // files whose names cannot be read
    int outside = 0;                    // files whose names lead out of the archive: "../phong.cpp", "/phong.cpp"
    std::string first_outside;
    std::set<std::string> edited;  // files that the framework has as well, with another text

    /// Notes a file that is no fragment by its name.
    void look_at_name(const std::string& path, const std::vector<std::string>& fragments);
};

inline bool is_archive(std::string_view name) {
    return name.ends_with(".zip") || name.ends_with(".tar") || name.ends_with(".tar.gz") || name.ends_with(".tgz");
}

/// Where fragments are expected, and in archives that lie beside them; where there is none, in all folders within; and
/// where there is none either, in the archives in them.
Found look_into_folder(const fs::path& folder, const std::vector<std::string>& fragments, const fs::path& framework);

/// Looks into a .zip or a .tar.gz; nothing is unpacked to the disk. framework: what FrameworkFiles compares with.
/// Throws SubmissionError. A kit has no library for archives, and says so.
Found look_into_archive(const fs::path& path, const std::vector<std::string>& fragments, const fs::path& framework);

/// Looks into those of found.archives, which lie in a folder, as into an archive within an archive: the bounds are for
/// all of them together. What cannot be read stays in found.archives. A kit leaves them all. Throws SubmissionError.
void look_into_archives(const fs::path& folder, const std::vector<std::string>& fragments, const fs::path& framework,
                        Found& found);

/// Writes a .zip of files and folders under these names, with their right to be run. Throws std::runtime_error; in a
/// kit always.
void write_zip(const fs::path& zip, const std::vector<std::pair<std::string, fs::path>>& entries);

/// The complaint about a file above most_source_bytes.
std::string too_large();

}  // namespace grade
