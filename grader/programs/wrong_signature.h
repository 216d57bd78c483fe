#pragma once

#include <string>

#include "programs/object.h"
#include "programs/sandbox.h"
#include "programs/toolchain.h"

namespace grade {

/// Why an object does not define its fragment: what it defines under that name, and what fragments.h declares.
///
/// shown  the student's file, as it is told
/// work   the folder of the step that finds names for people
std::string wrong_signature(const Toolchain& chain, const Sandbox& sandbox, const ObjectFile& object,
                            const std::string& fragment, const std::string& shown, const fs::path& work);

}  // namespace grade
