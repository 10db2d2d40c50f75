// The command line: parses arguments, runs the chosen command, turns errors into sentences and exit codes.
#pragma once

namespace gaspard {

/// Returns the exit code of the program; never throws.
int run_command_line(int argc, char** argv);

} // namespace gaspard
