// Interpolation errors against the number of cells (core/session/interpolation_study.hpp), computed on a
// thread of its own. A new study replaces the one before, whose thread ends by itself.
#pragma once

#include "core/session/interpolation_study.hpp"
#include "gui/document/background_study.hpp"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace gaspard {

class CellStudy {
  public:
    struct Result {
        std::vector<InterpolationRow> rows; ///< of the meshes that are done
        std::size_t total = 0;              ///< number of meshes; 0: not known yet
        std::string complaint;              ///< why it ended early; empty if it did not
        bool done = false;                  ///< all that there will be
    };

    /// `wake` is called on another thread whenever result() has changed; it may be empty.
    CellStudy(std::shared_ptr<const Catalogue> catalogue, std::function<void()> wake);

    void begin(const Scenario& scenario);
    /// A computation for another problem is cancelled; its result so far stays.
    void cancel() { study_.cancel(); }
    /// Discards the result so far.
    void forget() { cancel(), known_ = false; }
    /// Whether the result is, or will be, that of this problem.
    bool describes(const Scenario& scenario) const;
    Result result() const { return study_.result(); }

  private:
    std::shared_ptr<const Catalogue> catalogue_;
    Scenario scenario_;
    bool known_ = false; ///< describes scenario_
    BackgroundStudy<Result> study_;
};

} // namespace gaspard
