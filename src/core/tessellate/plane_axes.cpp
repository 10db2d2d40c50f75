#include "core/tessellate/plane_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gaspard {

bool has_plane_axes(const Mesh& mesh) { return mesh.space_dimension == 2 && cell_dimension(mesh.kind) == 2; }

std::string coordinate_name(bool vertical, bool computational) {
    if (computational) return vertical ? "η" : "ξ";
    return vertical ? "y" : "x";
}

AxisRange seen_range(double low, double high, double low_end, double high_end) {
    return {std::max(low, low_end), std::min(high, high_end)};
}

PlaneAxis plane_axis(const std::string& name, AxisRange range, double length, double spacing,
                     const std::function<double(const std::string&)>& extent) {
    PlaneAxis axis;
    if (!(range.low < range.high) || !(length > 0)) return axis;
    // Rounding of the mesh and of the view must not cost the labels of its ends.
    const double slack = 0.5 * range.span() / length;
    range = {range.low - slack, range.high + slack}, length += 1;
    const int count = std::clamp(static_cast<int>(length / spacing), 1, 12);
    std::vector<const Tick*> labelled;
    // With round numbers far apart there may be but one in the range.
    for (int more = count; labelled.size() < 2 && more <= 2 * count + 2; ++more) {
        std::vector<Tick> ticks = fitting_ticks({}, range, more, length, extent);
        if (!axis.ticks.empty() && ticks.size() <= axis.ticks.size()) continue;
        axis.ticks = std::move(ticks);
        labelled.clear();
        for (const Tick& tick : axis.ticks)
            if (!tick.label.empty()) labelled.push_back(&tick);
    }
    // Between the last two labels, or the two before those, that leave room.
    for (std::size_t i = labelled.size(); i-- > 1;) {
        const Tick &before = *labelled[i - 1], &after = *labelled[i];
        const double gap = (after.value - before.value) / range.span() * length -
                           (extent(before.label) + extent(after.label)) / 2;
        if (gap < extent(name)) continue;
        axis.name = name;
        // Middle of the gap, not of the values: labels differ in width.
        const double shift = (extent(before.label) - extent(after.label)) / 4 * range.span() / length;
        axis.name_at = (before.value + after.value) / 2 + shift;
        break;
    }
    return axis;
}

double label_room(const Box& box, const std::function<double(const std::string&)>& width) {
    double widest = 0;
    if (box.low.y < box.high.y)
        for (const Tick& tick : linear_ticks(box.low.y, box.high.y, 8))
            widest = std::max(widest, width(tick.label));
    for (const char* step : {"0.00", "−0.00", "−000.0", "−0.0000", "−2.5×10⁻⁵"})
        if (const double room = width(step); room >= widest) return room;
    return std::ceil(widest);
}

} // namespace gaspard
