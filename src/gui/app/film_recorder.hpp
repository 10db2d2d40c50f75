// Makes films of what the window has recorded, while the window goes on.
//
// Each frame goes through two threads, since there is one current ImGui context:
//
//   film's thread     the iterate, its triangles and colours     draws it, writes it, joins the frames
//   window's thread                                 lays it out,
//                                                   a few ms for each frame of the window
//
// While one frame is drawn, the next one is laid out.
#pragma once

#include "core/io/film_writer.hpp"
#include "core/scenario/scenario.hpp"
#include "gui/base/background_writer.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace gaspard {

/// All that a film is made of, as it is when the film begins.
struct FilmOrder {
    FilmPlan plan;
    const FilmFormat* format = nullptr;
    std::filesystem::path file; ///< absolute; of a format with many files their folder
    bool replace = false;       ///< the user has agreed to replace what is there
    Scenario scenario;          ///< with the view of the film
    std::shared_ptr<const Recording> recording;
    std::shared_ptr<const Snapshot> last; ///< the newest iterate of the recording
};

class FilmRecorder {
  public:
    /// The outcome of each film, or that it was cancelled, is a notice for `board`.
    explicit FilmRecorder(std::shared_ptr<NoticeBoard> board);
    /// Cancels what is not complete. On the window's thread, as the other functions.
    ~FilmRecorder();
    FilmRecorder(const FilmRecorder&) = delete;
    FilmRecorder& operator=(const FilmRecorder&) = delete;

    /// Only one at a time.
    void begin(FilmOrder order);
    bool busy() const { return film_ != nullptr; }
    void cancel();
    struct Progress {
        std::string what; ///< "film: frame 3 of 64"
        double done = 0;
    };
    std::optional<Progress> progress() const;
    /// Lays out the frame that waits for it, if there is one, and releases what is no longer needed.
    void work();

  private:
    class FilmInWork;
    std::shared_ptr<NoticeBoard> board_;
    std::shared_ptr<FilmInWork> film_; ///< its images belong to the window's thread
    BackgroundWriter writer_;          ///< last, so that it ends before what it uses
};

} // namespace gaspard
