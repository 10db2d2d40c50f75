// The program gaspard.
#include "cli/command_line.hpp"

int main(int argc, char** argv) { return gaspard::run_command_line(argc, argv); }
