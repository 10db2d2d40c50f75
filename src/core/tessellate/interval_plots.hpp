// How a mesh of an interval is shown: as plots. Positions are doubles, and distances from an end are formed
// from them directly, so that nodes at 1e-12 and at 1 - 1e-12 are where they are.
//
// What is plotted is the field that view.color names; without it, as the solution of no problem, the map
// x(xi). Beside a field NAME are plotted its further components NAME_2, NAME_3, ... and the same on the
// uniform mesh, NAME_uniform, NAME_2_uniform, ..., as far as the snapshot has them.
#pragma once

#include "core/base/parameter.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/plot.hpp"
#include "core/tessellate/plot_axis.hpp"

#include <vector>

namespace gaspard {

/// Plots over one coordinate, the physical one x or the computational one xi, to be drawn one above the
/// other with x axes of the same range.
struct IntervalColumn {
    Plot values;  ///< of the field, or the map
    Plot spacing; ///< widths of the cells
};

/// What the axes of a column show, in axis units: x and the vertical ones.
struct ColumnRanges {
    AxisRange x, values, spacing;
    friend bool operator==(const ColumnRanges&, const ColumnRanges&) = default;
};
/// Of each column, with all values; and what covers two such lists of equally many columns, or the other if
/// one is empty.
std::vector<ColumnRanges> shown_ranges(const std::vector<IntervalColumn>& columns);
std::vector<ColumnRanges> merged(const std::vector<ColumnRanges>& one,
                                 const std::vector<ColumnRanges>& other);

/// The height of `values` in a column; the rest is the spacing's.
inline constexpr double values_share = 0.66;

/// One column, or in the layout side-by-side two. `view`: values of view_rows(); `cells`: of the run. The
/// mesh is one of an interval (space_dimension 1). In each curve x never decreases, unless the mesh is
/// tangled or not finite.
std::vector<IntervalColumn> interval_plots(const Snapshot& snapshot, const Values& view,
                                           ColouringMaker& cells);
/// Of one snapshot alone.
std::vector<IntervalColumn> interval_plots(const Snapshot& snapshot, const Values& view);

/// Whether a mesh is shown so.
inline bool is_interval(const Mesh& mesh) { return mesh.space_dimension == 1; }

} // namespace gaspard
