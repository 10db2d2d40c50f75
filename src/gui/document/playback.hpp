// Which iterate of the runs is shown: the newest, or one that was recorded; and the replay of a recording.
//
// All runs that are shown stand at the same iteration, those that ended earlier at their last one. Runs with
// time stand at the same time instead: each at its iterate of the time that is nearest to that of the run
// that was moved to, or, of the newest iterates, to that of the active run until it has ended. Iterations are
// those of one of them, the longest (longest_run()).
#pragma once

#include "gui/document/document_run.hpp"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace gaspard {

/// Where runs with time stand: at an iterate of this time, of several the newest up to this iteration.
struct Moment {
    double t = 0;
    int iteration = 0;
};

class Playback {
  public:
    /// Iterations per second to choose from; 0 is as fast as frames are drawn.
    static constexpr std::array<double, 7> rates{1, 2, 5, 10, 30, 100, 0};

    /// Once per frame, `seconds` after the last one. A new history of the run shows the newest iterate.
    void update(const DocumentRun& run, double seconds) { update(run, run, seconds); }
    /// The same, where `longest` may be another run that is shown beside it.
    void update(const DocumentRun& run, const DocumentRun& longest, double seconds);

    /// The newest iterate is shown, also when another one comes.
    bool live() const { return !at_; }
    bool playing() const { return playing_; }
    /// The recording is looked at: its iterates are compared, those at its end as well. Ends with
    /// go_to_end() and with another iterate or history.
    bool compares() const { return compares_; }
    /// The iteration that is shown of the run.
    int iteration(const DocumentRun& run) const;
    /// The iterate of any run to show; null if there is none yet.
    std::shared_ptr<const Snapshot> snapshot(const DocumentRun& run);

    /// Shows the iterate that was recorded nearest to it, and stops playing. The last one is live.
    /// `longest`: a run that is shown beside it; if it is another one, the last one of `run` is not live, but
    /// a time at which that one stands as well.
    void go_to(const DocumentRun& run, double iteration, const DocumentRun* longest = nullptr);
    /// To the iterate that was recorded before or after the one that is shown.
    void go_back(const DocumentRun& run);
    void go_forward(const DocumentRun& run);
    void go_to_start(const DocumentRun& run);
    /// Fits the colours to the newest iterate again.
    void go_to_end();
    /// From where it stands; from the start if the newest is shown. Nothing if there is only one iterate.
    void play(const DocumentRun& run);
    void pause() { playing_ = false; }

    double rate() const { return rate_; }
    void set_rate(double per_second) { rate_ = per_second; }
    /// Begins again at the end.
    bool loops() const { return loops_; }
    void set_loops(bool loops) { loops_ = loops; }

    /// The picture, but not the view's value, goes back and forth between the computational mesh (0) and the
    /// physical one (1).
    bool blends() const { return blends_; }
    void set_blends(bool blends);
    double blend() const;

  private:
    void advance(const DocumentRun& run, bool solving, double seconds);
    void stand_at(const DocumentRun& run, double iteration);
    void show_newest();
    std::shared_ptr<const RecordedIterate> iterate(const DocumentRun& run) const;

    RunId run_{};
    std::uint64_t histories_ = 0;  ///< of the run, as last seen
    std::optional<double> at_;     ///< the iteration; while playing with a part of the way to the next one
    RunId of_{};                   ///< whose iterations, and whose time, these are
    std::optional<Moment> moment_; ///< at which other runs stand; empty: they have no time
    bool playing_ = false, compares_ = false, loops_ = false, blends_ = false;
    double rate_ = 10;
    double rested_ = 0;  ///< seconds at the end, before a replay begins again
    double blended_ = 0; ///< seconds
    struct Restored {
        std::shared_ptr<const RecordedIterate> of;
        std::shared_ptr<const Snapshot> snapshot;
    };
    std::map<RunId, Restored> restored_; ///< what was shown last
};

/// The number of the newest iterate; 0 if there is none.
int last_iteration(const DocumentRun& run);
/// The time of an iteration, recorded or between rows of the history that were kept; nullopt: it has none.
std::optional<double> time_at(const DocumentRun& run, int iteration);
/// The iteration at which `other` stands while `run` stands at this one: that of the nearest time, if both
/// have time; else the same, also where `other` has ended before.
int iteration_beside(const DocumentRun& run, const DocumentRun& other, int iteration);
/// The run that ends last, in time or, where one has no time, in iterations; of equal ones the one with more
/// iterations, or `run` itself. `others`: runs that are shown beside it, of which those without a recording
/// do not count.
const DocumentRun& longest_run(const DocumentRun& run, const std::vector<const DocumentRun*>& others);

/// The iterations of a history whose meshes have tangled cells, as ranges: "4 to 6" is {4, 6}. What was not
/// measured belongs to the range of the iterate before it.
std::vector<std::pair<int, int>> tangled_ranges(const std::vector<StepReport>& history);

} // namespace gaspard
