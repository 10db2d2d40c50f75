// Plans the plots that show a mesh of an interval (core/tessellate/interval_plots.hpp): what goes where, and
// how it is drawn fast.
#pragma once

#include "core/tessellate/extremes.hpp"
#include "core/tessellate/interval_plots.hpp"
#include "gui/base/screen_rect.hpp"
#include "gui/plot/plot_axes.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// What a user has zoomed to in the plots of one coordinate, which share its axis.
struct ColumnZoom {
    std::optional<AxisRange> x, values, spacing;
    friend bool operator==(const ColumnZoom&, const ColumnZoom&) = default;
};

/// What the plots of several snapshots cover together.
class ComparedRanges {
  public:
    /// Of each column; none if there are no snapshots. Computed only for other snapshots or another view.
    const std::vector<ColumnRanges>& of(const std::vector<std::shared_ptr<const Snapshot>>& snapshots,
                                        const Values& view);

  private:
    std::vector<std::shared_ptr<const Snapshot>> snapshots_;
    Values view_;
    std::vector<ColumnRanges> ranges_;
};

/// A plot to be drawn: what, and where it belongs.
struct PlannedPlot {
    PlotView view; ///< valid as long as `of`
    ScreenRect rect;
    std::size_t column = 0; ///< those of one column share their zoom
    bool spacing = false;   ///< it shows the widths of cells
    PlotZoom zoom{};
    std::shared_ptr<const void> of{};
};

class IntervalPlanner {
  public:
    /// The plots side by side in `available`, in the order of columns, with margins. `title` is written above
    /// those that have none of their own. Plots in a column begin and end at the same pixel; those of column
    /// i show held[i], if it is there; else they are zoomed as zooms[i] says, if it is there, and else the
    /// vertical axes cover compared[i], too.
    std::vector<PlannedPlot> plan(const Snapshot& snapshot, const Values& view, const std::string& title,
                                  ScreenRect available, const std::vector<ColumnZoom>& zooms, float scale,
                                  const std::vector<ColumnRanges>& compared = {},
                                  const std::vector<ColumnRanges>& held = {});

  private:
    struct Picture;
    void make(const Snapshot& snapshot, const Values& view, const std::string& title);

    ColouringMaker cells_;
    std::shared_ptr<const Mesh> mesh_; ///< what the picture was made of
    std::uint64_t version_ = 0;
    Values view_;
    std::string title_;
    std::shared_ptr<const Picture> picture_;
};

} // namespace gaspard
