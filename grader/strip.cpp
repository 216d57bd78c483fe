#include <exception>
#include <iostream>
#include <string_view>

#include "assignment/assignment.h"
#include "assignment/strip.h"

/// strip_solution [--check] SOLUTION STARTER [ASSIGNMENT]: makes the starter's fragments from the solution's, or with
/// --check says where they differ from what it would make. Those that assignment.toml gives, or leaves out, are
/// filled in.
int main(int argc, char** argv) {
    const bool check = argc > 1 && std::string_view(argv[1]) == "--check";
    if (check) --argc, ++argv;
    if (argc < 3 || argc > 4) {
        std::cerr << "strip_solution [--check] SOLUTION STARTER [ASSIGNMENT]\n";
        return 2;
    }
    const std::string solution = argv[1], starter = argv[2], assignment = argc == 4 ? argv[3] : "assignment.toml";

    try {
        const auto known = grade::fragments_in(solution);
        const auto files = grade::make_starter(solution, grade::read_assignment(assignment, known).asked());
        if (!check) {
            grade::write_starter(files, starter);
            return 0;
        }
        const auto lines = grade::drift(files, starter);
        for (const auto& line : lines) std::cerr << line << "\n";
        if (!lines.empty()) std::cerr << "Make them again: cmake --build --preset release --target starter_fragments\n";
        return lines.empty() ? 0 : 1;
    } catch (const std::exception& error) {
        std::cerr << error.what() << "\n";
        return 2;
    }
}
