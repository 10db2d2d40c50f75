// Sections of solids (core/tessellate/section.hpp) on a thread of their own, for those that take too long
// for a frame of the window.
#pragma once

#include "core/tessellate/section.hpp"

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace gaspard {

/// All that a section is made of, as values.
struct SectionJob {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const SolidFaces> faces;
    Points x{};
    std::vector<char> visible{};
    InsideChoice choice{};
    int pieces = 1;
    std::uint64_t number = 0; ///< of the caller, returned with the section
};

struct MadeSection {
    std::shared_ptr<const Mesh> mesh;
    std::shared_ptr<const Tessellation> tessellation; ///< null if there was not enough memory
    double seconds = 0;
    std::uint64_t number = 0; ///< of the job
};

/// Makes sections of one mesh after the other on the thread that calls it.
class SectionMaking {
  public:
    MadeSection make(const SectionJob& job);

  private:
    std::shared_ptr<const Mesh> mesh_;
    std::optional<SectionMaker> maker_;
};

class SectionWorker {
  public:
    SectionWorker();

    /// Takes the place of a job that waits.
    void post(SectionJob job);
    /// A job that waits is not done any more.
    void withdraw();
    /// The last section that was finished, once.
    std::optional<MadeSection> take();
    /// Whether a job waits or is being done, or its section waits to be taken.
    bool busy() const;

  private:
    void run(const std::stop_token& stop);

    mutable std::mutex mutex_;
    std::condition_variable_any posted_;
    std::optional<SectionJob> waiting_;
    std::optional<MadeSection> made_;
    bool working_ = false;
    std::jthread thread_; ///< last, so that it ends first
};

} // namespace gaspard
