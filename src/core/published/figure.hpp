// A figure of a paper as plain data: meshes and plots side by side. Independent of how it is drawn.
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
    std::string camera{}; ///< for meshes: view.camera; empty shows the whole mesh
};

struct Figure {
    std::string title;
    std::vector<FigurePanel> panels; ///< from left to right
};

} // namespace gaspard
