// Says when a feature of the monitor is narrower than the cells can carry, and what helps.
#pragma once

#include "gui/document/document_run.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace gaspard {

class NarrowFeature {
  public:
    /// About the newest iterate of a run; empty if its cells are narrow enough, or if its monitor is data,
    /// which has edges anyway. A mesh that has not adapted does not tell: what the last adapted one of the
    /// same domain and monitor said holds, so that a reset does not hide it. Measures each iterate once.
    std::string warning(const Catalogue& catalogue, const DocumentRun& run);

  private:
    std::shared_ptr<const Mesh> mesh_; ///< of the iterate that was measured
    std::uint64_t version_ = 0;
    double share_ = 0;
    /// What the last adapted mesh said, of which problem.
    struct Verdict {
        Section domain, monitor, source;
        double share = 0;
    };
    std::optional<Verdict> verdict_;
};

} // namespace gaspard
