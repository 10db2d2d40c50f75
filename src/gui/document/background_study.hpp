// Results that a thread of their own computes bit by bit while the window shows those that are there.
#pragma once

#include "core/base/error.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace gaspard {

/// Result: a value with members `complaint` (std::string), why it ended early, and `done` (bool), all that
/// there will be. A new study replaces the one before, whose thread ends by itself.
template <class Result>
class BackgroundStudy {
  public:
    /// Changes the result; to be called by the task.
    using Change = std::function<void(const std::function<void(Result&)>&)>;
    using Task = std::function<void(const Change& change, const std::stop_token& stop)>;

    /// `wake` is called on another thread whenever result() has changed; it may be empty.
    explicit BackgroundStudy(std::function<void()> wake) : wake_(std::move(wake)) {}
    /// Waits for the steps at work.
    ~BackgroundStudy() {
        thread_.request_stop();
        for (Leaving& one : leaving_) one.thread.request_stop(); // all, before the first is waited for
    }
    BackgroundStudy(const BackgroundStudy&) = delete;
    BackgroundStudy& operator=(const BackgroundStudy&) = delete;

    void begin(Task task) {
        cancel();
        work_ = std::make_shared<Work>();
        thread_ =
            std::jthread([work = work_, wake = wake_, task = std::move(task)](const std::stop_token& stop) {
                const Change change = [&](const std::function<void(Result&)>& edit) {
                    work->change(edit);
                    if (wake) wake();
                };
                std::string complaint;
                try {
                    task(change, stop);
                } catch (const Interrupted&) { // the result so far stays
                } catch (const std::exception& error) {
                    complaint = error.what();
                }
                change([&](Result& result) { result.done = true, result.complaint = complaint; });
            });
    }
    /// The study at work ends early; its result so far stays.
    void cancel() {
        std::erase_if(leaving_, [](const Leaving& one) { return one.work->copy().done; });
        if (!thread_.joinable()) return;
        thread_.request_stop();
        leaving_.push_back({work_, std::move(thread_)});
    }
    Result result() const { return work_ ? work_->copy() : Result{}; }

  private:
    /// What the thread shares with the window.
    class Work {
      public:
        void change(const std::function<void(Result&)>& edit) {
            const std::lock_guard lock(mutex_);
            edit(result_);
        }
        Result copy() const {
            const std::lock_guard lock(mutex_);
            return result_;
        }

      private:
        mutable std::mutex mutex_;
        Result result_;
    };
    struct Leaving {
        std::shared_ptr<Work> work;
        std::jthread thread;
    };

    std::function<void()> wake_;
    std::shared_ptr<Work> work_; ///< null: none was begun
    std::vector<Leaving> leaving_;
    std::jthread thread_;
};

/// As many as the machine has.
inline int study_threads() { return static_cast<int>(std::max(1U, std::thread::hardware_concurrency())); }

} // namespace gaspard
