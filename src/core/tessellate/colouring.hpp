// What the cells of an image or a file are coloured by: a snapshot and a choice (the rows of the section
// "view") give values, the map and the range that turn them into colours, and a histogram for the legend.
//
//   monitor          m at the nodes
//   area             of the physical cell; length of a line, volume of a solid
//   jacobian         det dx/dxi, the smallest sampled in each cell
//   equidistribution M_i / mean of M - 1 of each cell: 0 where the monitor is equidistributed
//   displacement     |x - xi| of the nodes
//   aspect_ratio, skewness, orthogonality, alignment
//                    of the cells (diagnostics/cell_quality.hpp)
//   a field of the method or the monitor (MethodType::fields, MonitorType::fields), by its name
//   none             no colours
#pragma once

#include "core/diagnostics/cell_quality.hpp"
#include "core/session/recording.hpp"
#include "core/session/snapshot.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "core/tessellate/colour_choice.hpp"
#include "core/tessellate/colour_map.hpp"
#include "core/tessellate/contours.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

struct Colouring {
    std::string name;     ///< as in ColourChoice
    std::string label;    ///< for a legend: "cell area"
    std::string symbol{}; ///< "m"; may be empty
    FieldPlace place = FieldPlace::node;
    std::vector<double> values{}; ///< of the mesh's nodes or cells
    const ColourMap* map = nullptr;
    ColourRange range{};
    /// How many values lie in each part of the range, from low to high, in more parts where there are more
    /// values; what is outside counts for none.
    std::vector<std::uint32_t> histogram{};
    bool below = false, above = false; ///< some values lie outside
    ContourLevels contours{};          ///< in the range; none for values of cells

    std::array<unsigned char, 3> colour(std::size_t i) const {
        return colour_at(*map, range.position(values[i]));
    }
};

/// Colours the snapshots of one run after the other. Where a snapshot was not measured
/// (method.diagnostics_every), Jacobians are taken at the nodes, and M_i are those measured last, so that
/// colours do not flicker.
class ColouringMaker {
  public:
    /// Empty for "none", for a field that the snapshot does not have, and for M_i before they were first
    /// measured.
    std::optional<Colouring> make(const Snapshot& snapshot, const ColourChoice& choice);
    /// Notes what was measured; needed for snapshots that make() does not see.
    void see(const Snapshot& snapshot);
    /// Where the map folds, if that is known; else cells with a Jacobian of zero or less at any sampled
    /// point. Ascending.
    std::vector<std::uint32_t> tangled(const Snapshot& snapshot);

    /// Of every cell.
    std::vector<double> measures(const Snapshot& snapshot);
    const std::vector<double>& jacobians(const Snapshot& snapshot); ///< valid until the next snapshot
    /// Null if the cells are lines; valid until the next snapshot.
    const CellQuality* quality(const Snapshot& snapshot);
    const std::vector<double>& masses() const { return mass_; } ///< M_i as last measured; empty before

  private:
    std::optional<std::vector<double>> values(const Snapshot& snapshot, const std::string& name);

    std::shared_ptr<const Mesh> mesh_;
    std::optional<CellGeometry> geometry_;
    std::optional<CellQualityMeter> quality_meter_; ///< of the mesh; made when it is needed
    std::optional<CellQuality> quality_;            ///< of the snapshot seen last
    std::vector<double> mass_;
    std::vector<double> jacobian_; ///< at the nodes, of the snapshot seen last; empty where not needed yet
    std::uint64_t seen_version_ = 0;
};

/// The view with this range instead of an automatic one; as it is if its range is fixed or `range` is empty.
Values with_range(Values view, const std::optional<ColourRange>& range);

/// The newest iterate that is kept; if that has tangled cells, the last one before the first tangled one.
/// Null if there are none.
std::shared_ptr<const RecordedIterate> last_sound(const Recording& recording);

/// One range for a whole recording: covers the automatic ranges of the first iterate and of the last sound
/// one (diverged values would leave the rest one colour). `newest`: that iterate in double precision, if it
/// is known. Nothing if neither has such values.
std::optional<ColourRange> range_of_recording(const Recording& recording, const Snapshot* newest,
                                              const ColourChoice& choice);

/// Extends a range so that it covers the automatic range of a snapshot, if that has such values.
void cover(std::optional<ColourRange>& range, const Snapshot& snapshot, const ColourChoice& choice);

/// The colouring of one snapshot alone.
std::optional<Colouring> make_colouring(const Snapshot& snapshot, const ColourChoice& choice);

} // namespace gaspard
