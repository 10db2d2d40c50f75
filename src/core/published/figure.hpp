// A figure of a paper as plain data: meshes and plots side by side. Who draws it is not its business.
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
    std::string camera{}; ///< of a mesh, as view.camera; empty: all of it
};

struct Figure {
    std::string title;
    std::vector<FigurePanel> panels; ///< from left to right
};

} // namespace gaspard
