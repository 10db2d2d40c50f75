#include "gui/viewport/interval_planner.hpp"

#include "gui/viewport/viewport_text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

/// Those of the curves whose x are in order, which drawing needs.
std::vector<std::optional<Extremes>> extremes_of(const Plot& plot) {
    std::vector<std::optional<Extremes>> all;
    for (const Curve& curve : plot.curves) {
        all.emplace_back();
        bool in_order = true;
        for (std::size_t i = 1; i < curve.x.size(); ++i) in_order = in_order && curve.x[i - 1] <= curve.x[i];
        if (!in_order) continue;
        all.back().emplace();
        for (const double y : curve.y) all.back()->append(y);
    }
    return all;
}

PlotView view_of(const Plot& plot, const std::vector<std::optional<Extremes>>& extremes) {
    PlotView view = view_of(plot);
    for (std::size_t i = 0; i < view.curves.size(); ++i)
        if (extremes[i]) view.curves[i].extremes = &*extremes[i];
    return view;
}

/// Makes the vertical axis cover a range besides its own, unless a range is asked for.
void cover(PlotView& view, AxisRange range) {
    if (view.y.low || view.y.high) return;
    const AxisRange home = home_range(view, true);
    view.y.low = from_axis(view.y, std::min(home.low, range.low));
    view.y.high = from_axis(view.y, std::max(home.high, range.high));
}

/// Makes both axes show these ranges.
void hold(PlotView& view, AxisRange x, AxisRange y) {
    view.x.low = from_axis(view.x, x.low), view.x.high = from_axis(view.x, x.high);
    view.y.low = from_axis(view.y, y.low), view.y.high = from_axis(view.y, y.high);
}

/// Makes curves of plots above each other begin and end at the same pixel.
void align(PlannedPlot& above, PlannedPlot& below, float scale) {
    float left = 0, right = 0;
    for (const PlannedPlot* plot : {&above, &below}) {
        const PlotFrame frame = make_frame(plot->view, plot->rect, plot->zoom, scale);
        left = std::max(left, frame.area.min.x - plot->rect.min.x);
        right = std::max(right, plot->rect.max.x - frame.area.max.x);
    }
    for (PlannedPlot* plot : {&above, &below}) plot->view.left = left, plot->view.right = right;
}

} // namespace

const std::vector<ColumnRanges>&
ComparedRanges::of(const std::vector<std::shared_ptr<const Snapshot>>& snapshots, const Values& view) {
    if (snapshots == snapshots_ && (snapshots.empty() || view == view_)) return ranges_;
    snapshots_ = snapshots, view_ = view;
    ranges_.clear();
    for (const auto& snapshot : snapshots)
        ranges_ = merged(ranges_, shown_ranges(interval_plots(*snapshot, view)));
    return ranges_;
}

struct IntervalPlanner::Picture {
    std::vector<IntervalColumn> columns;
    std::vector<std::vector<std::optional<Extremes>>> values, spacing; ///< of each column
};

void IntervalPlanner::make(const Snapshot& snapshot, const Values& view, const std::string& title) {
    if (picture_ && mesh_ == snapshot.mesh && version_ == snapshot.version && view_ == view &&
        title_ == title)
        return;
    auto picture = std::make_shared<Picture>();
    picture->columns = interval_plots(snapshot, view, cells_);
    for (IntervalColumn& column : picture->columns) {
        if (column.values.title.empty()) column.values.title = title;
        picture->values.push_back(extremes_of(column.values));
        picture->spacing.push_back(extremes_of(column.spacing));
    }
    mesh_ = snapshot.mesh, version_ = snapshot.version;
    view_ = view, title_ = title;
    picture_ = std::move(picture);
}

std::vector<PlannedPlot> IntervalPlanner::plan(const Snapshot& snapshot, const Values& view,
                                               const std::string& title, ScreenRect available,
                                               const std::vector<ColumnZoom>& zooms, float scale,
                                               const std::vector<ColumnRanges>& compared,
                                               const std::vector<ColumnRanges>& held) {
    make(snapshot, view, title);
    const float margin = viewport_margin * scale, gap = viewport_gap * scale;
    const std::size_t count = picture_->columns.size();
    const float width = std::floor(available.width() / static_cast<float>(count));
    const float middle = std::round(available.min.y + static_cast<float>(values_share) * available.height());
    std::vector<PlannedPlot> plots;
    for (std::size_t i = 0; i < count; ++i) {
        const float left = available.min.x + width * static_cast<float>(i) + margin;
        const float right = left + width - 2 * margin;
        const ColumnZoom zoom = i < zooms.size() ? zooms[i] : ColumnZoom{};
        PlannedPlot above{.view = view_of(picture_->columns[i].values, picture_->values[i]),
                          .rect = {{left, available.min.y + gap}, {right, middle - gap / 2}},
                          .column = i,
                          .zoom = {zoom.x, zoom.values},
                          .of = picture_};
        PlannedPlot below{.view = view_of(picture_->columns[i].spacing, picture_->spacing[i]),
                          .rect = {{left, middle + gap / 2}, {right, available.max.y - gap}},
                          .column = i,
                          .spacing = true,
                          .zoom = {zoom.x, zoom.spacing},
                          .of = picture_};
        if (i < held.size())
            hold(above.view, held[i].x, held[i].values), hold(below.view, held[i].x, held[i].spacing);
        else if (i < compared.size())
            cover(above.view, compared[i].values), cover(below.view, compared[i].spacing);
        align(above, below, scale);
        plots.push_back(std::move(above));
        plots.push_back(std::move(below));
    }
    return plots;
}

} // namespace gaspard
