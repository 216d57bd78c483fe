#pragma once

#include <string>

namespace CLI {
class App;
}

namespace grade::course {

struct AgainArguments {
    std::string record, submission, out;
    bool trusted = false;
};

CLI::App* add_replay_command(CLI::App& app, AgainArguments& arguments);
CLI::App* add_verify_command(CLI::App& app, AgainArguments& arguments);

/// grade replay RECORD SUBMISSION: with the record's seed, selection and limits, into a new record. Returns the exit
/// code.
int run_replay(const AgainArguments& arguments, const std::string& toolchain, const std::string& command);

/// grade verify RECORD SUBMISSION. Returns the exit code: 0 where points and verdicts are the record's, else 1. Throws
/// rt::InputError for texts that the record is not of.
int run_verify(const AgainArguments& arguments, const std::string& toolchain, const std::string& command);

struct CompareArguments {
    std::string before, after, better;
};

CLI::App* add_compare_command(CLI::App& app, CompareArguments& arguments);

/// grade compare A B, of two records or two graded classes: whose points rise or fall, and why. Returns the exit code:
/// 0 where none do, else 1.
int run_compare(const CompareArguments& arguments);

}  // namespace grade::course
