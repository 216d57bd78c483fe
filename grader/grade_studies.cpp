#include "commands/command_line.h"

int main(int argc, char** argv) { return grade::run_studies_command_line(argc, argv); }
