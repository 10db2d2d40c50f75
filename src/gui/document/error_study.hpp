// Errors of a problem with layers over one of its variables (core/session/layer_study.hpp), computed on a
// thread of its own with the values of a run, except those that vary.
#pragma once

#include "core/session/layer_study.hpp"
#include "gui/document/background_study.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

class ErrorStudy {
  public:
    struct Result {
        std::vector<StudyPoint> points; ///< of the runs that are done
        std::string complaint;
        bool done = false;
    };

    /// `wake` is called on another thread whenever result() has changed; it may be empty.
    ErrorStudy(std::shared_ptr<const Catalogue> catalogue, std::function<void()> wake);

    /// A study of other values is cancelled, and once the run `rests`, that of these begins.
    void follow(const Scenario& scenario, const StudyVariable& variable, bool rests);
    /// Nobody looks: what is at work ends. A result that is complete stays.
    void leave();

    /// Of result(); null if none was begun.
    const StudyPlan* plan() const { return begun_ ? &*begun_ : nullptr; }
    /// Whether the result is, or will be, that of what is followed.
    bool current() const { return begun_ && !incomplete_ && wanted_ && same_study(*begun_, *wanted_); }
    Result result() const { return study_.result(); }

  private:
    void cut_short();

    std::shared_ptr<const Catalogue> catalogue_;
    std::optional<Scenario> seen_{}; ///< of wanted_
    StudyVariable variable_{};
    std::optional<StudyPlan> wanted_{}, begun_{};
    bool incomplete_ = false; ///< begun_ was cancelled at work
    BackgroundStudy<Result> study_;
};

} // namespace gaspard
