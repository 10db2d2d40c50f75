// The command line: parses arguments, runs the command, and reports errors as messages and exit codes.
#pragma once

namespace gaspard {

/// Returns the exit code of the program. Does not throw.
int run_command_line(int argc, char** argv);

} // namespace gaspard
