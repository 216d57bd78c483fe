#pragma once

#include <optional>
#include <string>

#include "programs/sandbox.h"
#include "programs/toolchain.h"

namespace grade {

/// A source with its own macros put in and its conditions decided, by the compiler; each line keeps its number. What it
/// includes is not read, so that macros of headers stay as they are.
///
/// None: it cannot be preprocessed so, or is too long then. Throws std::runtime_error where the disk is full.
///
/// work   an empty folder of its own
std::optional<std::string> preprocessed(const Toolchain& chain, const Sandbox& sandbox, const std::string& text,
                                        const fs::path& work);

}  // namespace grade
