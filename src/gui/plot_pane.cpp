#include "gui/plot_pane.hpp"

#include "gui/part_window.hpp"
#include "gui/plot_widget.hpp"

namespace gaspard {

void PlotPane::frame(const Document& document, const ItemRectangle& first, const ItemRectangle& second,
                     const FrameContext& context) {
    const auto plot = [&](const char* name, const ItemRectangle& part, const Plot& data) {
        begin_part(name, part);
        plot_widget(name, data, ImGui::GetContentRegionAvail(), context.theme, context.scale);
        ImGui::End();
        context.items[name] = part;
    };
    plot("plot.residual", first, document.residual_plot());
    plot("plot.equidistribution", second, document.equidistribution_plot());
}

} // namespace gaspard
