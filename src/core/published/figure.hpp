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
    // For meshes: values of the view.
    std::string camera{};        ///< view.camera; empty shows the whole mesh
    std::string colour = "none"; ///< view.color
    std::string cut{};           ///< view.cut
    bool lines = true;           ///< view.lines
};

struct Figure {
    std::string title;
    std::vector<FigurePanel> panels; ///< from left to right
};

} // namespace gaspard
