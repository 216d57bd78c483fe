#pragma once

#include <string>
#include <vector>

#include "calibration/workshop.h"

namespace CLI {
class App;
}

namespace grade::calibration {

struct CalibrateArguments {
    std::string results;  // folder; empty: calibration/ in the build's folder
    std::string out;      // folder of the report; empty: that of the results
    std::string shard = "1/1";
    bool fast = false, report = false;
    int seeds = 1;  // of fast
    Amount amount;
    int jobs = 0;
    std::vector<std::string> names;  // of variants or fragments; empty: all
};

CLI::App* add_calibrate_command(CLI::App& app, CalibrateArguments& arguments);

/// grade calibrate: grades fragments that are known to be wrong or right, and reports how often the verdict is so.
///
/// command  as it was typed
/// Returns whether nothing is off: with `fast`, each wrong variant fails and each right one passes; else, that the work
/// is done. Throws rt::InputError for what is wrong with the arguments.
bool calibrate(const CalibrateArguments& arguments, const std::string& toolchain, const std::string& command);

}  // namespace grade::calibration
