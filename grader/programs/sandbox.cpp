#include "programs/sandbox.h"

#include "files/files.h"
#include "programs/process.h"

namespace grade {

namespace {

constexpr const char* bubblewrap = "/usr/bin/bwrap";

}  // namespace

Sandbox find_sandbox(bool trusted) {
    if (trusted) return {Sandbox::Kind::limits_only, "resource limits only: the code is its owner's", {}};
    if (!fs::exists(bubblewrap))
        return {Sandbox::Kind::limits_only, "resource limits only: bubblewrap is not installed", {}};

    Sandbox sandbox{Sandbox::Kind::host,
                    "bubblewrap: no network, no other processes, files read-only; resource limits", {}};
    const fs::path folder = temporary_place();
    if (!run(inside(sandbox, {"/usr/bin/true"}, {}, folder), Limits{}, folder.string()).good())
        return {Sandbox::Kind::limits_only, "resource limits only: bubblewrap does not work on this machine", {}};
    return sandbox;
}

std::vector<std::string> inside(const Sandbox& sandbox, const std::vector<std::string>& command,
                                const std::vector<fs::path>& readable, const fs::path& folder) {
    if (sandbox.kind == Sandbox::Kind::limits_only) return command;
    std::vector<std::string> words{bubblewrap,      "--unshare-all", "--die-with-parent",
                                   "--new-session", "--cap-drop",    "ALL",
                                   "--ro-bind",     "/usr",          "/usr",
                                   "--proc",        "/proc",         "--dev",
                                   "/dev",          "--tmpfs",       "/tmp"};
    for (const char* system : {"/bin", "/lib", "/lib64", "/etc/alternatives", "/etc/ld.so.cache"})
        words.insert(words.end(), {"--ro-bind-try", system, system});
    for (const fs::path& path : sandbox.readable)
        words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    for (const fs::path& path : readable) words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    words.insert(words.end(), {"--bind", folder.string(), folder.string(), "--chdir", folder.string(), "--"});
    words.insert(words.end(), command.begin(), command.end());
    return words;
}

}  // namespace grade
