#pragma once

#include <optional>

#include "programs/toolchain.h"

namespace grade {

/// The folder where what one run leaves for the next is kept: the toolchain's, or, where that cannot be written, one of
/// this user's (XDG Base Directory Specification). None: there is nowhere to write.
std::optional<fs::path> cache_folder(const Toolchain& chain);

/// A folder to search before all others: what every fragment includes, compiled once for all. Made at the first call,
/// by any thread; empty where the compiler finds no such files by itself, or nothing can be kept.
fs::path precompiled_header(const Toolchain& chain);

}  // namespace grade
