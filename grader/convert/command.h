#pragma once

#include <string>

namespace CLI {
class App;
}

namespace grade {

struct ConvertArguments {
    std::string record, format, out;
};

CLI::App* add_convert_command(CLI::App& app, ConvertArguments& arguments);

/// grade convert RECORD --to FORMAT: throws rt::InputError for a record that is none or not complete.
void run_convert(const ConvertArguments& arguments);

}  // namespace grade
