#include "gui/layout.hpp"

#include <algorithm>
#include <cmath>

namespace gaspard {

Layout compute_layout(float width, float height, float em, float top) {
    // Whole units, so that edges are sharp.
    const float toolbar = std::round(2.9F * em), status = std::round(5.4F * em);
    const float side = std::round(std::min(28 * em, 0.46F * width));
    const float bottom = std::max(top + toolbar, height - status);
    Layout layout;
    layout.toolbar = {0, top, width, std::min(top + toolbar, bottom)};
    layout.sidebar = {0, layout.toolbar.bottom, side, bottom};
    layout.status = {0, bottom, width, std::max(height, bottom)};

    // The plots stand where they leave the picture, which is about square, the most room: right or below.
    const ItemRectangle rest{side, layout.toolbar.bottom, width, bottom};
    const float column = std::round(std::clamp(0.32F * rest.width(), 14 * em, 30 * em));
    const float row = std::round(std::clamp(0.36F * rest.height(), 10 * em, 17 * em));
    const float beside = std::min(rest.width() - column, rest.height());
    const float above = std::min(rest.width(), rest.height() - row);
    if (beside >= above) {
        const float x = std::max(rest.left, rest.right - column),
                    y = std::round((rest.top + rest.bottom) / 2);
        layout.viewport = {rest.left, rest.top, x, rest.bottom};
        layout.residual = {x, rest.top, rest.right, y};
        layout.equidistribution = {x, y, rest.right, rest.bottom};
    } else {
        const float x = std::round((rest.left + rest.right) / 2), y = std::max(rest.top, rest.bottom - row);
        layout.viewport = {rest.left, rest.top, rest.right, y};
        layout.residual = {rest.left, y, x, rest.bottom};
        layout.equidistribution = {x, y, rest.right, rest.bottom};
    }
    return layout;
}

} // namespace gaspard
