#pragma once

#include "studies/command.h"

/// The commands of the second program: studies.h says what each is for.
namespace grade {

Command convert_command(CLI::App& app);

namespace authoring {
Command audit_command(CLI::App& app);
Command new_command(CLI::App& app);
}  // namespace authoring

namespace calibration {
Command calibrate_command(CLI::App& app);
}

namespace convergence {
Command converge_command(CLI::App& app);
}

namespace course {
Command class_command(CLI::App& app);
Command compare_command(CLI::App& app);
Command merge_command(CLI::App& app);
Command replay_command(CLI::App& app);
Command verify_command(CLI::App& app);
}  // namespace course

namespace lesson {
Command lesson_command(CLI::App& app);
}

namespace stress {
Command stress_command(CLI::App& app);
}

}  // namespace grade
