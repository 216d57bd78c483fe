#include "commands/commands.h"
#include "rt/processor.h"

int main(int argc, char** argv) {
    rt::require_processor();
    return grade::run_command_line(argc, argv);
}
