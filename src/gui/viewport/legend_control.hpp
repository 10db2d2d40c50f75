// The legend under the mouse: the ends of its bar are dragged, the numbers at them typed, a double click
// shows all values again, a right click offers colour maps and scales. It changes values of the view.
#pragma once

#include "core/base/parameter.hpp"
#include "core/tessellate/colouring.hpp"
#include "gui/base/frame_context.hpp"
#include "gui/viewport/legend.hpp"

#include <optional>
#include <string>

namespace gaspard {

/// The value at a place of the bar of a range, 0 at its low end and 1 at its high end; beyond them, too.
double value_on_bar(const ColourRange& range, double place);

class LegendControl {
  public:
    /// After the item that receives the mouse. True if the mouse is the legend's, and not the mesh's.
    bool interact(Values& view, const Colouring& colouring, const LegendPlaces& places, float scale);
    /// The handles, and what is open over the legend. Keys "legend", "legend.low", "legend.high",
    /// "legend.low.value", "legend.high.value", "legend.value", "legend.menu.NAME".
    void draw(Values& view, const Colouring& colouring, const LegendPlaces& places,
              const FrameContext& context);

  private:
    enum class Part { none, low, high, low_value, high_value, rest };
    static Part part_at(const LegendPlaces& places, ImVec2 at, float scale);
    void drag(Values& view, const LegendPlaces& places);
    void draw_field(Values& view, const Colouring& colouring, const LegendPlaces& places,
                    const FrameContext& context);
    void draw_menu(Values& view, const Colouring& colouring, const FrameContext& context);

    Part held_ = Part::none;
    ColourRange before_;      ///< when the handle was pressed
    Part typed_ = Part::none; ///< the value whose field is open
    std::string text_;        ///< in it
    bool opens_field_ = false, opens_menu_ = false;
    bool refused_ = false; ///< what was typed cannot be the value
};

} // namespace gaspard
