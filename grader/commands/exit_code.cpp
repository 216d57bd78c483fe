#include "commands/exit_code.h"

#include <fmt/format.h>

#include <exception>

#include "files/interrupt.h"
#include "rt/files/scene_reader.h"

namespace grade {

int exit_code_of(const std::function<int()>& command) {
    try {
        return command();
    } catch (const Interrupted&) {
        return stopped;
    } catch (const rt::InputError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return usage;
    } catch (const std::exception& error) {
        fmt::print(stderr, "the grader failed: {}\n", error.what());
        return infrastructure;
    }
}

std::string command_of(int argc, char** argv) {
    std::string command = "grade";
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        const bool plain =
            !word.empty() && word.find_first_not_of(
                                 "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+") == word.npos;
        std::string quoted = "'";
        for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
        command += " " + (plain ? word : quoted + "'");
    }
    return command;
}

}  // namespace grade
