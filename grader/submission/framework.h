#pragma once

#include <string>

#include "submission/submission.h"

namespace grade {

/// The files of the framework, which submissions hold as well: what is edited there is ignored, and told.
class FrameworkFiles {
public:
    /// folder: rt/ is in it; empty: nothing is compared.
    explicit FrameworkFiles(fs::path folder) : folder_(std::move(folder)) {}

    /// Whether a path within a submission is that of a file of the framework.
    bool has(const std::string& path) const;

    /// Whether such a file's text is another one than the framework's.
    bool differs(const std::string& path, const std::string& text) const;

    /// Those of a submission's folder that differ, as paths within it; rt/ is in `within`.
    std::vector<std::string> edited_in(const fs::path& submission, const std::string& within) const;

private:
    fs::path file(const std::string& path) const;

    fs::path folder_;
};

}  // namespace grade
