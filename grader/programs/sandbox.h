#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace grade {

namespace fs = std::filesystem;

/// Where student code is compiled and run. Limits hold everywhere; walls only where the machine can build them.
struct Sandbox {
    enum class Kind { host, limits_only };
    Kind kind = Kind::limits_only;
    std::string description;         // for the report: what it is, and why it is no better
    std::vector<fs::path> readable;  // seen by every command, beside what it names: libraries
};

/// What this machine offers: bubblewrap where it works, else limits only.
///
/// trusted  the code is the caller's own: limits only
Sandbox find_sandbox(bool trusted);

/// The command that runs a command in a sandbox: it sees the system's programs, what is readable, and one folder that
/// it may write to, where it starts; no network, no other process.
std::vector<std::string> inside(const Sandbox& sandbox, const std::vector<std::string>& command,
                                const std::vector<fs::path>& readable, const fs::path& folder);

}  // namespace grade
