// Asks what a film of a recorded solve shows, and how it is saved: motions, iterates, format, size, length,
// parts and file. Motions and formats are the rows of film_motions() and film_formats().
#pragma once

#include "core/base/parameter.hpp"
#include "core/io/film_files.hpp"
#include "gui/base/item_rectangles.hpp"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gaspard {

/// What there is to film.
struct FilmSubject {
    FilmIterates iterates; ///< at least one
    int shown = 0;         ///< the one that the window shows
    std::shared_ptr<const Mesh> mesh;
    std::string camera;  ///< of the window, as view.camera; empty: there is none
    std::string earlier; ///< another view, such as one that was copied; may be empty
};

class FilmDialog {
  public:
    struct Choice {
        FilmPlan plan;
        const FilmFormat* format = nullptr;
        std::string file;     ///< as typed, with its ending; of a format with many files their folder
        Values view;          ///< of the film
        bool replace = false; ///< there are such files, and the user has agreed
    };
    /// `view`: as it is shown. `stem`: the suggested path without the ending.
    void show(FilmSubject subject, const Values& view, std::string stem);
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Keys "film.motion=NAME", "film.from", "film.from-present", "film.to", "film.to-present", "film.first",
    /// "film.last" or, of the motion time, "film.from-time", "film.to-time", "film.format",
    /// "film.format=NAME", "film.width", "film.height", "film.rate", "film.seconds", "film.default",
    /// "film.estimate", "film.axes" and the other parts, "film.file", "film.browse", "film.problem",
    /// "film.ok", "film.cancel".
    std::optional<Choice> draw(ItemRectangles& items);
    /// True once after the button that asks for another file was pressed.
    bool take_browse_wish();
    /// The chosen file or folder; with the ending of the format.
    std::string file() const;
    /// Of the chosen format, ".mp4"; empty for a folder.
    std::string ending() const;
    /// A file that the user has chosen, also to be replaced.
    void set_file(const std::string& file);
    /// What is wrong with the choice, as a sentence; empty if nothing is.
    std::string problem() const;
    /// "64 frames, 6.4 s, and 1 s more at the end".
    std::string estimate() const;

  private:
    void draw_motions(ItemRectangles& items);
    void draw_cameras(ItemRectangles& items);
    void draw_iterates(ItemRectangles& items);
    void draw_times(ItemRectangles& items);
    void draw_format(ItemRectangles& items);
    void draw_size(ItemRectangles& items);
    void draw_length(ItemRectangles& items);
    void draw_file(ItemRectangles& items);
    std::optional<Choice> draw_end(ItemRectangles& items);
    FilmPlan plan() const;
    void check_times(const FilmPlan& film) const;
    double rate() const;
    const FilmFormat& format() const;
    bool present(const std::string& file) const;

    bool open_ = false, browse_ = false;
    FilmSubject subject_;
    std::optional<Values> view_;
    std::vector<std::string> unsuitable_; ///< of each motion: why it does not suit the mesh; else empty
    std::vector<std::string> missing_;    ///< of each format: what its program is missing; else empty
    std::vector<bool> motions_;           ///< which are chosen
    std::size_t format_ = 1;              ///< its index
    std::string from_, to_;
    int first_ = 0, last_ = 0, still_ = 0; ///< the last is of motions that show one iterate
    double from_time_ = 0, to_time_ = 0;   ///< of the motion time
    double width_ = 0, height_ = 0;
    double rate_ = 0;                 ///< 0: the usual one
    std::optional<double> seconds_{}; ///< empty: as long as usual
    std::string stem_;                ///< the file without its ending
    std::string agreed_;              ///< what may be replaced
    std::string asked_;               ///< what the user was asked about
};

} // namespace gaspard
