#include "commands/command_line.h"
#include "rt/processor.h"

int main(int argc, char** argv) {
    rt::require_processor();
    return grade::run_studies_command_line(argc, argv);
}
