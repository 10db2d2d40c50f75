#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>

namespace gaspard {

int run_command_line(int argc, char** argv) {
    CLI::App app("Gaspard: watch a mesh adapt", "gaspard");
    app.set_version_flag("--version", "gaspard 0.1.0");
    CLI11_PARSE(app, argc, argv);
    return 0;
}

} // namespace gaspard
