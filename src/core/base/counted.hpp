// Numbers of things in sentences.
#pragma once

#include <string>

namespace gaspard {

/// "1 time step", "2 time steps"
inline std::string counted(int count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

} // namespace gaspard
