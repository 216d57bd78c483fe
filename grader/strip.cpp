#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "assignment.h"
#include "build/strip.h"

/// strip_solution: makes the starter's fragments, or with --check says where they differ from what it would make.
int main(int argc, char** argv) {
    CLI::App app("Makes the starter's fragments from the solution's");
    std::string solution, starter, assignment = "assignment.toml";
    bool check = false;
    app.add_option("SOLUTION", solution, "folder of the solution's fragments")->required();
    app.add_option("STARTER", starter, "folder of the starter's fragments")->required();
    app.add_option("--assignment", assignment, "the list of fragments, for those that are given")
        ->capture_default_str();
    app.add_flag("--check", check, "write nothing; fail where the starter differs");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }

    try {
        std::set<std::string> given;
        for (const auto& fragment : grade::read_assignment(assignment).fragments)
            if (fragment.given) given.insert(fragment.name);
        const auto files = grade::make_starter(solution, given);
        if (!check) {
            grade::write_starter(files, starter);
            return 0;
        }
        const auto lines = grade::drift(files, starter);
        for (const auto& line : lines) std::cerr << line << "\n";
        if (!lines.empty())
            std::cerr << "Make them again: cmake --build --preset release --target starter_fragments\n";
        return lines.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
