#include "commands/studies.h"

#include <fmt/format.h>
#include <unistd.h>

#include "build/files.h"
#include "commands/exit_code.h"

namespace grade {

int start_study(const Study& study, char** argv) {
    std::error_code error;
    const std::string program = fs::read_symlink("/proc/self/exe", error).string() + "_studies";
    execv(program.c_str(), argv);
    if (fs::exists(program, error))
        fmt::print(stderr, "{}: cannot be started; grade {} is in it\n", program, study.name);
    else
        fmt::print(stderr, "grade {0} is in a program of its own, {1}, which is not built yet: ./grade {0} builds it, and so does "
                           "cmake --build --preset release --target grade_studies\n", study.name, program);
    return infrastructure;
}

}  // namespace grade
