// Asks how to save a figure of the view: size, resolution, ground, text, parts, format and file.
#pragma once

#include "core/base/parameter.hpp"
#include "gui/base/item_rectangles.hpp"

#include <optional>
#include <string>

namespace gaspard {

enum class FigureKind { png, svg, pdf };

/// Of its files: ".png".
const char* figure_ending(FigureKind kind);

class FigureDialog {
  public:
    struct Choice {
        FigureKind kind = FigureKind::png;
        std::string file;     ///< as typed, with its ending
        Values view;          ///< of the figure
        bool replace = false; ///< the file exists, and the user has agreed
    };
    /// `view`: as it is shown. `stem`: the suggested path without the ending.
    void show(const Values& view, std::string stem);
    void close() { open_ = false; }
    bool open() const { return open_; }
    /// Keys "figure.png", "figure.svg", "figure.pdf", "figure.unit", "figure.width", "figure.height",
    /// "figure.dpi", "figure.ground", "figure.colour", "figure.theme", "figure.text_size", "figure.legend",
    /// "figure.caption", "figure.note", "figure.file", "figure.browse", "figure.ok", "figure.cancel".
    std::optional<Choice> draw(ItemRectangles& items);
    /// True once after the button that asks for another file was pressed.
    bool take_browse_wish();
    /// The chosen file; with the ending of the format.
    std::string file() const;
    FigureKind kind() const { return kind_; }
    /// A file that the user has chosen, also to be replaced.
    void set_file(const std::string& file);

  private:
    void draw_kind(ItemRectangles& items);
    void draw_size(ItemRectangles& items);
    void draw_ground(ItemRectangles& items);
    void draw_parts(ItemRectangles& items);
    void draw_file(ItemRectangles& items);
    void set_pixels();
    std::string size_note() const;
    std::string problem() const;

    bool open_ = false, browse_ = false, millimetres_ = false;
    FigureKind kind_ = FigureKind::png;
    std::optional<Values> view_;
    double width_ = 0, height_ = 0; ///< in the chosen unit
    int ground_ = 0;                ///< theme, transparent, colour
    std::string colour_ = "#ffffff";
    std::string stem_;   ///< the file without its ending
    std::string agreed_; ///< the file that may be replaced
    std::string asked_;  ///< the file that the user was asked about
};

} // namespace gaspard
