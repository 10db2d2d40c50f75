#include "gui/base/actions.hpp"

#include "core/base/check.hpp"
#include "core/base/join.hpp"

#include <algorithm>

namespace gaspard {

const Action& find_action(std::span<const Action> actions, std::string_view name) {
    const auto found =
        std::find_if(actions.begin(), actions.end(), [&](const Action& row) { return row.name == name; });
    GASPARD_CHECK(found != actions.end());
    return *found;
}

const Action* action_for_key(std::span<const Action> actions, std::string_view key) {
    for (const Action& row : actions)
        if (std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end()) return &row;
    return nullptr;
}

std::string describe_keys(const Action& action) { return join(action.keys, " or "); }

std::string tooltip_of(const Action& action) {
    return std::string(action.help) + "\nKey: " + describe_keys(action);
}

std::span<const MouseHelp> mouse_help() {
    static constexpr MouseHelp rows[] = {
        {"Drag the view", "Pan; rotate a mesh in space (with Shift, the middle or the right button: pan)."},
        {"Drag the monitor's centre",
         "Move the monitor by its handle, a small circle with a cross; the mesh follows."},
        {"Drag a control point",
         "Move a control point of a planar patch or of a convex domain, a small square; the mesh follows."},
        {"Drag the arrow of a cut", "Move the plane by the arrow's foot, turn it by the tip."},
        {"Drag a section line", "Move its end; the plot shows the values of the colours along it."},
        {"Drag an end of the legend", "Set the range of the colours."},
        {"Double-click the legend", "On a number at an end: type it; elsewhere: show all values."},
        {"Right-click the legend", "Choose colour map, logarithmic scale and histogram."},
        {"Wheel", "Zoom at the pointer."},
        {"Click", "Click a cell or a node to inspect it; click beside the mesh to clear the selection."},
        {"Double-click", "Centre the view on a point; on a globe, rotate the point to the front."},
        {"Drag or wheel on the bar", "Show another iterate of the solve, with the bar below the mesh."},
        {"Click a plot", "Show the iterate of that place."},
        {"Drag the knob of a plot", "Show other iterates; in an error study, change the value."},
        {"Drag or wheel on a plot", "Pan or zoom; with Shift or Ctrl, or on an axis, in one direction only."},
        {"Right drag on a plot", "Zoom to a rectangle; double-click to show everything."},
        {"Drag a field",
         "Change a value; Shift: finely; double-click: type it; wheel and arrow keys after a click: step."},
        {"Drag a border", "Change the size of the parameter panel or of the plots."},
        {"Click a kept run", "Change its name in the list of runs; the eye hides it, the cross removes it."},
        {"Drop a file",
         "Open a scenario; use an image or a field as the monitor, a spline patch or solid or the mesh of a "
         "convex domain as the domain; start from a state."},
    };
    return rows;
}

std::string actions_markdown(std::span<const Action> actions) {
    std::string text = "| key | action | what it does |\n| --- | --- | --- |\n";
    for (const Action& row : actions)
        text += "| " + describe_keys(row) + " | " + std::string(row.label) + " | " + std::string(row.help) +
                " |\n";
    for (const MouseHelp& row : mouse_help())
        text += "| " + std::string(row.what) + " | | " + std::string(row.help) + " |\n";
    return text;
}

} // namespace gaspard
