#pragma once

#include <optional>
#include <string>

#include "programs/toolchain.h"

namespace grade {

/// The folder where what one run leaves for the next is kept: the toolchain's, or, where that cannot be written, one of
/// this user's (XDG Base Directory Specification). None: there is nowhere to write.
std::optional<fs::path> cache_folder(const Toolchain& chain);

/// The folder for pages: the one that is asked for; without one, `report` in the cache for what its user edits, so that
/// the pages of all commands stand beside each other; else none, which is empty.
fs::path page_folder(const std::string& asked, bool own, const Toolchain& chain);

/// A folder to search before all others: what every fragment includes, compiled once for all. Made at the first call,
/// by any thread; empty where the compiler finds no such files by itself, or nothing can be kept.
fs::path precompiled_header(const Toolchain& chain);

}  // namespace grade
