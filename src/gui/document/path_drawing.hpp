// A path that is drawn with the mouse: the places of a monitor's point while it is dragged, with their times,
// become time.path.
#pragma once

#include "core/scenario/catalogue.hpp"
#include "core/scenario/clock.hpp"

#include <optional>
#include <string>
#include <vector>

namespace gaspard {

class PathDrawing {
  public:
    /// The next drag is a path.
    void arm() { armed_ = true, path_.clear(); }
    void give_up() { armed_ = false, path_.clear(); }
    bool armed() const { return armed_; }
    bool drawing() const { return armed_ && !path_.empty(); }
    /// The point of the scenario's monitor that a path moves is there after `seconds`, counted from any time.
    /// `first`: a key of the point. Other points are left out.
    void add(const Scenario& scenario, const std::string& first, double seconds);
    /// The drag is over. The scenario `before` it with the path as its time, from 0 to the length of the
    /// drag, at the speed of the hand; nothing if the point did not move for long enough.
    std::optional<Scenario> finish(const Catalogue& catalogue, const Scenario& before);

  private:
    bool armed_ = false;
    double begin_ = 0;
    std::vector<PathPoint> path_;
};

} // namespace gaspard
