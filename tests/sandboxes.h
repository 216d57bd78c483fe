#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include "catch.h"
#include "files/files.h"
#include "programs/sandbox.h"

/// Where steps are tried.
namespace grade {

/// Whether other users reach what is in a folder: what a step of another user compiles with is there.
inline bool is_open_to_others(fs::path folder) {
    for (; folder != folder.root_path(); folder = folder.parent_path())
        if ((fs::status(folder).permissions() & fs::perms::others_exec) == fs::perms::none) return false;
    return true;
}

/// Every kind of sandbox that works on this machine.
inline std::vector<Sandbox> sandboxes() {
    std::vector<Sandbox> all;
    for (const auto& [kind, own_user] :
         {std::pair(Sandbox::Kind::host, false), {Sandbox::Kind::container, true}, {Sandbox::Kind::container, false}}) {
        Sandbox sandbox{kind, {}, {}, {}, own_user};
        if (own_user && (geteuid() != 0 || !is_open_to_others(fs::current_path()))) continue;
        const std::string fault = fault_of(sandbox, {});
        sandbox.description = fmt::format("kind {}, a user of its own: {}", int(kind), own_user);
        if (fault.empty())
            all.push_back(sandbox);
        else
            WARN(sandbox.description << " does not work here: " << fault);
    }
    return all;
}

/// A folder that a step of any user may start in.
struct StepFolder {
    StepFolder() {
        fs::permissions(outer.path(), fs::perms(0711));
        fs::create_directory(folder);
    }
    TemporaryFolder outer;
    fs::path folder = outer.path() / "step";
};

}  // namespace grade
