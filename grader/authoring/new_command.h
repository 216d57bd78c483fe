#pragma once

#include "authoring/new.h"

namespace CLI {
class App;
}

namespace grade::authoring {

struct NewArguments {
    NewFragment fragment;
    NewVariant variant;
    std::string scene, scene_like, check, check_of;
    std::vector<CLI::App*> kinds;  // fragment, scene, check, mistake
};

/// grade new fragment|scene|check|mistake: the files of a new part of the assignment, where FILL IN says what is to be
/// written.
CLI::App* add_new_command(CLI::App& app, NewArguments& arguments);

/// Throws rt::InputError.
void run_new(const NewArguments& arguments, const std::string& toolchain);

}  // namespace grade::authoring
