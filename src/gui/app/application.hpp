// What the window does in a frame: panels, toolbar, shortcuts and messages around a document. It consists of
// ImGui calls and values and needs neither a window nor OpenGL; the caller draws the views of meshes.
//
// The caller owns the ImGui context, its style and its input; between ImGui::NewFrame() and ImGui::Render()
// it calls frame().
#pragma once

#include "gui/app/file_dialogs.hpp"
#include "gui/app/file_tasks.hpp"
#include "gui/app/film_recorder.hpp"
#include "gui/app/menus.hpp"
#include "gui/app/messages.hpp"
#include "gui/base/actions.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/layout.hpp"
#include "gui/base/settings.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/document.hpp"
#include "gui/document/narrow_feature.hpp"
#include "gui/document/path_drawing.hpp"
#include "gui/document/playback.hpp"
#include "gui/document/replay_range.hpp"
#include "gui/document/values_in_time.hpp"
#include "gui/panels/comparison_panel.hpp"
#include "gui/panels/dialogs.hpp"
#include "gui/panels/error_plots.hpp"
#include "gui/panels/help_window.hpp"
#include "gui/panels/parameter_panel.hpp"
#include "gui/panels/plot_pane.hpp"
#include "gui/panels/run_list.hpp"
#include "gui/panels/study_panel.hpp"
#include "gui/panels/toast.hpp"
#include "gui/panels/viewport_pane.hpp"
#include "gui/panels/why_panel.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

struct ApplicationOptions {
    std::function<void()> wake{};        ///< called on other threads when there is something to collect
    OutputFolders output{"gaspard-out"}; ///< files are written to folders of it with the names of scenarios
    std::optional<Scenario> named{};     ///< see Document::open
    Settings settings{};
    std::vector<std::string> complaints{}; ///< what was wrong with the settings, for the log
    bool in_background = false;            ///< parts of a picture that take long may follow later
};

/// What the window's loop has to know after a frame.
struct WindowState {
    const Theme& theme; ///< of the next frame
    std::string theme_name;
    float text_size = 1; ///< relative to the theme
    bool fullscreen = false, quit = false;
    bool awaits_text = false; ///< a field is about to take what is typed
    bool animating = false;   ///< every frame differs from the last one, even without input or news
};

class Application {
  public:
    Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                ApplicationOptions options = {});
    /// Shows a finished run, which cannot be changed.
    Application(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& finished,
                ApplicationOptions options = {});
    /// Scales everything relative to the theme: the display's scale times WindowState::text_size.
    void set_scale(float scale) { scale_ = scale; }

    /// Collects the results of other threads; true if there is something new to show.
    bool collect();
    /// Draws everything except the scenes of views().
    void frame();
    /// A key as the table of actions writes it. Ignored while a text field has the keyboard. True if it did
    /// something.
    bool press_key(std::string_view key);
    void perform(std::string_view action);
    /// Looks at a file on another thread: a scenario is shown, an image or a field becomes the monitor, a
    /// spline patch the domain (file_kinds()).
    void open_file(const std::filesystem::path& file);

    const std::string& title() { return run().title; }
    WindowState window_state() const;
    /// True once after a screenshot was requested; the caller answers with save_image().
    bool take_screenshot_request() { return std::exchange(taking_screenshot_, false); }
    void save_image(Image image);
    /// Saves the requested plot, if any, as the image that `draw` returns.
    void save_plot(const std::function<Image(const Plot&)>& draw);
    /// To be written when the window closes.
    Settings settings();

    std::span<const Action> actions() const { return actions_; }
    Document& document() { return document_; }
    /// The views of meshes that belong to the last frame.
    const std::vector<ShownView>& views() const { return viewport_pane_.views(); }
    /// In the next frame the screen still shows these, with which axes and marks stay.
    void stay_with(std::vector<ShownView> meshes) { viewport_pane_.stay_with(std::move(meshes)); }
    /// The plots of an interval, which are drawn already.
    std::vector<PlannedPlot> interval_plots() const { return viewport_pane_.plots(); }
    const ItemRectangle& viewport_rectangle() const { return layout_.viewport; }
    const ItemRectangles& items() const { return items_; }
    const Messages& messages() const { return messages_; }
    /// What the status bar says of the iterate shown.
    std::vector<StatusCell> status() { return status_cells(run(), playback_.iteration(run())); }
    /// The plots of errors of other runs, as far as they are shown.
    const ErrorPlots& error_plots() const { return error_plots_; }

  private:
    Application(std::shared_ptr<const Catalogue> catalogue, ApplicationOptions options);
    DocumentRun& run() { return document_.active(); }
    DocumentViewport& viewport() { return document_.viewports().front(); }
    std::vector<Action> make_actions();
    std::vector<Action> edit_actions();
    std::vector<Action> solve_actions();
    std::vector<Action> camera_actions();
    std::vector<Action> layout_actions();
    std::vector<Action> show_actions();
    std::vector<Action> window_actions();
    std::vector<Action> file_actions();
    Action layout_action(std::string_view name, std::string_view label, std::string_view key,
                         std::string_view help);
    Action view_toggle(std::string_view key, std::string_view label, std::string_view shortcut,
                       std::string_view help);
    Action part_toggle(std::string_view setting, std::string_view label, std::string_view key,
                       std::string_view help);
    const Action& action(std::string_view name) const { return find_action(actions_, name); }
    bool on_interval(); ///< the active run has a mesh of an interval, shown as plots
    bool in_space();
    bool shows_solid();
    void toggle_cut();
    void flip_cut();
    /// The other runs whose meshes can be shown beside that of the active run.
    std::vector<const DocumentRun*> runs_beside();
    std::vector<ShownRun> shown_beside();
    std::vector<const DocumentRun*> runs_shown_beside(); ///< those that are shown beside it now
    const DocumentRun& longest();
    bool working();
    bool text_expected() const;
    void take_messages();
    void note_what_is_missing();
    bool available(const std::string& choice) const;
    void use_quadratic_cells();
    bool has_formula();
    void edit_as_formula();
    void draw_formula_button();
    bool follow(WhyWish wish, Scenario& scenario);
    bool draw_why_section(Scenario& scenario);
    void take_path();
    bool draw_time_section(const PanelContext& context, Scenario& scenario);
    void draw_error_section();
    void follow_study();
    void follow(const MenuChoice& choice);
    void arrange();
    void draw_sidebar();
    std::vector<std::string> view_keys();
    void draw_view(const PanelContext& context);
    void draw_plots(const FrameContext& context);
    void draw_plots_left_out(const FrameContext& context);
    void draw_status(const FrameContext& context);
    void draw_viewport(const FrameContext& context);
    std::optional<ColourRange> replay_range();
    Toast toast();
    const StepReport* shown_report();
    std::optional<int> first_tangled();
    void go_to_tangled();
    void run_or_pause();
    void step_forward();
    Plot section_of(const PlotChoice& choice);
    void offer_section_line(const std::array<PlotChoice, 2>& before);
    void draw_log();
    void draw_comparison();
    void draw_dialogs();
    void look_from(const std::string& direction);
    void copy_camera();
    void paste_camera();
    const std::string& viewed_theme() { return viewport().view.text("theme"); }
    void follow_theme();
    void set_text_size(double size);
    bool can_cancel();
    void cancel();
    void keep();
    void go_on();
    void begin_path();
    void leave_path();
    std::vector<Handle> handles_now();
    void move_in_history(bool forward);
    void begin_burst();
    void record_edits();
    void fulfil(const PlotWish& wish);
    Plot plot_for_file(const PlotWish& wish);
    void sweep(const PlotSweep& sweep);
    void export_files(const std::string& formats, const ExportDialog::Choice& choice = {});
    void ask_what_to_export();
    Scenario scenario_to_save();
    void save_scenario();
    void ask_where_to_save();
    void take_answer(const FileAnswer& answer);
    void save_as(const ScenarioToSave& choice);
    void take_figure(FigureDialog::Choice choice);
    void ask_how_to_film();
    void take_film(const FilmDialog::Choice& choice);
    void draw_progress_bars();
    void open_scenario(const Scenario& scenario);
    void take_opening();
    void open_builtin(const std::string& name);
    void take_file(const FileOfValue& chosen);
    void take_data(const DataFile& data);
    void reload_data();
    void change_values(const Scenario& scenario);

    std::shared_ptr<const Catalogue> catalogue_;
    Settings settings_;
    Messages messages_;
    FileDialogs file_dialogs_;
    std::uint64_t saved_in_ = 0;     ///< how many openings preceded the last save
    std::filesystem::path saved_as_; ///< the chosen file that it was last saved to; empty: none
    std::string closing_note_;       ///< of the last end, which is in the log
    std::shared_ptr<const Mesh> looked_for_missing_;
    std::string patch_note_; ///< "p.xml: patch 1 of 312 ...", as last said
    std::uint64_t openings_seen_ = 0;
    std::filesystem::path opening_file_; ///< of the scenario on its way; empty: a built-in one
    Menus menus_;
    std::vector<Action> actions_ = make_actions(); ///< bound to this object
    ParameterPanel panel_;
    StudyPanel study_panel_;
    ItemRectangles items_;
    Layout layout_;
    Theme theme_;
    float scale_ = 1;
    std::shared_ptr<TessellationCache> tessellations_ = std::make_shared<TessellationCache>();
    ViewportPane viewport_pane_{tessellations_};
    PlotPane plot_pane_;
    ComparisonPanel comparison_panel_;
    RunList run_list_;
    ToastPanel toast_;
    Playback playback_;
    PathDrawing path_;
    Scenario before_path_;   ///< what the path that is being drawn began with
    bool path_left_ = false; ///< in the middle of a drag, whose rest moves nothing
    ReplayRange replay_range_;
    ReplayEnds replay_ends_;
    std::optional<int> before_click_; ///< in a plot: the iteration that was shown; empty: the newest
    bool sidebar_before_ = true;      ///< before the size for projectors
    NarrowFeature narrow_feature_;
    ValuesInTime values_in_time_;
    std::optional<Plot> plot_to_save_;
    std::string plot_name_;    ///< of the file to come
    std::string closed_cut_;   ///< view.cut before it was closed
    Box cut_box_;              ///< around the solid that it belongs to
    double wheeled_ = 0;       ///< when the wheel was last turned, by ImGui::GetTime()
    bool wheel_burst_ = false; ///< nothing else was done since
    bool quit_ = false, fullscreen_ = false;
    HelpWindow help_;
    AboutWindow about_;
    bool error_table_shown_ = false;
    bool screenshot_ = false;        ///< asked for
    bool taking_screenshot_ = false; ///< this frame is the screenshot: it shows no tooltip
    FileTasks files_;
    FilmRecorder films_;
    /// What the dialog of films is about: the recording as it was when it was opened.
    struct ToFilm {
        std::shared_ptr<const Recording> recording;
        std::shared_ptr<const Snapshot> last;
        Scenario scenario;
    };
    std::optional<ToFilm> to_film_;
    CellStudy study_;        ///< of the active run
    ErrorPlots error_plots_; ///< of the active run
    Document document_;      ///< last, so that its threads end before what they use
};

} // namespace gaspard
