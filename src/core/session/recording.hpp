// The iterates of a run, kept so that each can be looked at again: positions and fields in single precision,
// within a budget of memory. Some of them have their state as well, from which the run can go on.
//
// The solver thread adds, other threads read. When the budget is used up, every other iterate is dropped, and
// from then on every second, fourth, ... is kept; the first and the newest always are.
#pragma once

#include "core/method/method.hpp"
#include "core/session/snapshot.hpp"

#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace gaspard {

/// An iterate in about half of the memory of its snapshot.
class RecordedIterate {
  public:
    explicit RecordedIterate(const Snapshot& snapshot, std::shared_ptr<const State> state = {});
    int iteration() const { return rest_.report.iteration; }
    const StepReport& report() const { return rest_.report; }
    std::uint64_t version() const { return rest_.version; } ///< of the snapshot
    std::size_t bytes() const { return bytes_; }
    /// Null for most iterates.
    const std::shared_ptr<const State>& state() const { return state_; }
    /// Positions and values rounded to single precision, all else as it was.
    std::shared_ptr<const Snapshot> restore() const;

  private:
    Snapshot rest_;                  ///< without positions and without values of fields
    std::vector<float> coordinates_; ///< all x, then all y, then all z, as many as the mesh's space has
    std::vector<std::vector<float>> values_; ///< of the fields
    std::shared_ptr<const State> state_;
    std::size_t bytes_ = 0;
};

class Recording {
  public:
    /// `budget` in bytes; at least two iterates are kept, however large they are.
    explicit Recording(std::size_t budget) : budget_(budget) {}
    /// Both keep the iterates, which are shared.
    Recording(const Recording& other);

    /// Forgets all iterates: a new history begins.
    void begin();
    /// An iteration that is not larger than the newest replaces it and all after it.
    void add(const Snapshot& snapshot, std::shared_ptr<const State> state = {});
    /// Whether an iterate should come with its state: about one in eight of those that are kept, and the
    /// first.
    bool wants_state(int iteration) const;
    /// The newest iterate with a state of those up to `iteration`, or the first one; null if there are none.
    std::shared_ptr<const RecordedIterate> with_state(int iteration) const;
    /// A larger one brings nothing back.
    void set_budget(std::size_t budget);
    std::size_t budget() const;

    /// The iterations that are kept, ascending.
    std::vector<int> iterations() const;
    /// The newest iterate that is kept of those up to `iteration`, or the first one; null if there are none.
    std::shared_ptr<const RecordedIterate> at(int iteration) const;
    /// The one whose time is nearest to t. Of several with that time, the iterates of the solve for the first
    /// time, it is the newest of those up to `iteration`, or the first. Null if they have no time.
    std::shared_ptr<const RecordedIterate> at_time(double t, int iteration) const;
    /// The first of them whose mesh has tangled cells.
    std::optional<int> first_tangled() const;
    std::size_t bytes() const;
    /// How many iterations lie between two that are kept.
    int stride() const;

  private:
    static constexpr int between_states = 8;
    void thin_out();

    mutable std::mutex mutex_;
    std::size_t budget_, bytes_ = 0;
    int stride_ = 1;
    std::vector<std::shared_ptr<const RecordedIterate>> kept_; ///< by iteration
};

} // namespace gaspard
