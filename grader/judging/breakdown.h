#pragma once

#include <vector>

#include "checks/kit/check.h"
#include "programs/programs.h"
#include "record/record.h"

namespace grade {

/// Why a fragment gives no answer to calls: the line, and what is wrong there, as its program with sanitizers tells.
/// Empty: it answers, or there are no sanitizers.
std::string breakdown_of(const Programs& programs, const Toolchain& chain, const std::string& fragment,
                         const Rows& calls);

/// The same of a picture.
std::string breakdown_of(const Programs& programs, const Toolchain& chain, const std::string& fragment,
                         const Render& picture, std::uint64_t seed);

/// Runs what has taken all of its time once more: into a finding that says nothing else go the loop that does not end
/// and the first call that it does not answer.
///
/// solution  its program
/// checks    all checks of the grading with this seed
void find_endless(const Programs& programs, const fs::path& solution, const Toolchain& chain,
                  const FragmentRecord& fragment, const std::vector<Check>& checks, std::uint64_t seed,
                  Finding& finding);

}  // namespace grade
