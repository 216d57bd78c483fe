#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace grade::authoring {

struct AuditArguments {
    std::vector<std::string> fragments;
};

/// grade audit: what fragments lack to be handed out.
CLI::App* add_audit_command(CLI::App& app, AuditArguments& arguments);

/// Returns the exit code: 0; 1 where something lacks.
int run_audit(const AuditArguments& arguments, const std::string& toolchain);

}  // namespace grade::authoring
