#pragma once

#include <map>
#include <string>
#include <vector>

#include "build/submission.h"

namespace grade {

/// A submission's files by path, those that could be fragments: FRAGMENT.cpp in any folder.
struct Found {
    std::map<std::string, std::string> texts, complaints;
};

/// Looks into a .zip or a .tar.gz; nothing is unpacked to the disk. Throws SubmissionError. A kit has no library for
/// archives, and says so.
Found look_into_archive(const fs::path& path, const std::vector<std::string>& fragments);

/// The complaint about a file above most_source_bytes.
std::string too_large();

}  // namespace grade
