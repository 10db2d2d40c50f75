// The dialogs about files: open, choose the file of a value, save, export, figures, films. One of them is
// shown at a time.
#pragma once

#include "core/scenario/scenario.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/settings.hpp"
#include "gui/panels/export_dialog.hpp"
#include "gui/panels/figure_dialog.hpp"
#include "gui/panels/file_browser.hpp"
#include "gui/panels/file_row.hpp"
#include "gui/panels/film_dialog.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gaspard {

/// What the user has chosen.
struct FileToOpen {
    std::string path;
};
struct FileOfValue {
    std::string key; ///< "monitor.file"
    std::string path;
};
struct ScenarioToSave {
    std::string file, title;
    bool packed = false; ///< with the content of its data files
};
using FileAnswer = std::variant<FileToOpen, FileOfValue, ScenarioToSave, ExportDialog::Choice,
                                FigureDialog::Choice, FilmDialog::Choice>;

class FileDialogs {
  public:
    /// In the folder that was used last.
    void ask_what_to_open(const Settings& settings);
    /// A file for a value of the scenario. Its folder is listed with those files that could be meant.
    void ask_for_value(const FileWish& wish, const Scenario& scenario);
    /// `file`: the one that is suggested.
    void ask_where_to_save(const Scenario& scenario, const std::filesystem::path& file);
    /// `folder`: the usual one.
    void ask_what_to_export(const Scenario& scenario, bool splines, const std::filesystem::path& folder);
    /// `folder`: the usual one for images.
    void ask_how_to_draw(const Values& view, const std::filesystem::path& folder);
    /// `folder`: the usual one for films.
    void ask_how_to_film(FilmSubject subject, const Values& view, const std::filesystem::path& folder);

    bool open() const { return browser_.open() || export_.open() || figure_.open() || film_.open(); }
    bool opening() const { return browser_.opening(); } ///< its text field does not take input yet
    void close();                                       ///< the topmost one
    std::optional<FileAnswer> draw(const Settings& settings, ItemRectangles& items);

    std::optional<FolderWish> take_wish() { return browser_.take_wish(); }
    void set_listing(FolderListing listing) { browser_.set_listing(std::move(listing)); }

  private:
    bool draw_save_fields(ItemRectangles& items);
    FileAnswer answer(const std::string& path);
    std::optional<FileAnswer> draw_browser(const Settings& settings, ItemRectangles& items);
    std::optional<FileAnswer> draw_export(ItemRectangles& items);
    std::optional<FileAnswer> draw_figure(ItemRectangles& items);
    std::optional<FileAnswer> draw_film(ItemRectangles& items);

    enum class Purpose { open, value, save, export_folder, figure_file, film_file };
    Purpose purpose_ = Purpose::open;
    FileBrowser browser_;
    ExportDialog export_;
    FigureDialog figure_;
    FilmDialog film_;
    std::string film_ending_; ///< that the browser looks for
    std::string key_;         ///< of the value
    ScenarioToSave to_save_;
    bool with_data_ = false; ///< the scenario to save refers to files, which can be packed into it
};

} // namespace gaspard
