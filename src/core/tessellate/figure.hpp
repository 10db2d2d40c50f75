// A figure as plain data: meshes and plots side by side. The graphics draw it without knowing where it comes
// from.
#pragma once

#include "core/session/snapshot.hpp"
#include "core/tessellate/plot.hpp"

#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace gaspard {

struct FigurePanel {
    std::string title;
    std::variant<std::shared_ptr<const Snapshot>, Plot> content;
};

struct Figure {
    std::string title;
    std::vector<FigurePanel> panels; ///< from left to right
};

} // namespace gaspard
