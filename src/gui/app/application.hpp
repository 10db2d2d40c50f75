// What the window does in a frame: panels, toolbar, shortcuts and messages around a document. All of it are
// ImGui calls and values, so it runs without a window and without OpenGL; who has both draws the pictures it
// asks for.
//
// The caller owns the ImGui context, its style and its input; between ImGui::NewFrame() and ImGui::Render()
// it calls frame().
#pragma once

#include "gui/base/actions.hpp"
#include "gui/base/background_writer.hpp"
#include "gui/base/item_rectangles.hpp"
#include "gui/base/layout.hpp"
#include "gui/base/settings.hpp"
#include "gui/base/theme.hpp"
#include "gui/document/document.hpp"
#include "gui/panels/comparison_panel.hpp"
#include "gui/panels/dialogs.hpp"
#include "gui/panels/log_panel.hpp"
#include "gui/panels/parameter_panel.hpp"
#include "gui/panels/plot_pane.hpp"
#include "gui/panels/run_list.hpp"
#include "gui/panels/viewport_pane.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gaspard {

struct ApplicationOptions {
    std::function<void()> wake{}; ///< called on other threads when there is something to collect
    std::filesystem::path output = "gaspard-out"; ///< exports and pictures go into `output`/<scenario>
    Settings settings{};
    std::vector<std::string> complaints{}; ///< what was wrong with the settings, for the log
};

class Application {
  public:
    Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                ApplicationOptions options = {});
    /// Around a run that was solved elsewhere: to be looked at, not to be worked with.
    Application(std::shared_ptr<const Catalogue> catalogue, const FinishedRun& finished,
                ApplicationOptions options = {});
    /// How much larger than the theme says everything is drawn: the display's density times text_size().
    void set_scale(float scale) { scale_ = scale; }

    /// Takes over what other threads have produced; true if there is something new to show.
    bool collect();
    /// Draws everything but the pictures of the meshes.
    void frame();
    /// A key as the table of actions writes it. Ignored while a text field has the keyboard. True if it did
    /// something.
    bool press_key(std::string_view key);
    void perform(std::string_view action);
    /// A scenario file, read on another thread; takes the place of what is shown once it is found good.
    void open_file(const std::filesystem::path& file);

    const std::string& title() { return run().title; }
    bool quit_requested() const { return quit_; }
    /// How the caller is to style the next frame, and whether the window is to fill the screen.
    const Theme& theme() const { return theme_; }
    /// A dialog is about to be written in: what is typed meanwhile is meant for it.
    bool awaits_text() const { return open_dialog_.opening() && !error_.open(); }
    const std::string& theme_name() const { return settings_.window.text("theme"); }
    float text_size() const { return static_cast<float>(settings_.window.real("text_size")); }
    bool fullscreen() const { return fullscreen_; }
    /// Every frame differs from the last one, also without input or news.
    bool animating() const { return viewport_pane_.spinning(); }
    /// True once after a screenshot was asked for; the answer is save_image().
    bool take_screenshot_request() { return std::exchange(taking_screenshot_, false); }
    void save_image(Image image);
    /// Saves the plot that was asked for, if any, as the picture that `draw` makes of it.
    void save_plot(const std::function<Image(const Plot&)>& draw);
    /// What is to be remembered when the window closes.
    Settings settings();

    std::span<const Action> actions() const { return actions_; }
    Document& document() { return document_; }
    /// The meshes that the last frame asks for.
    const std::vector<ShownView>& views() const { return viewport_pane_.views(); }
    const ItemRectangle& viewport_rectangle() const { return layout_.viewport; }
    const ItemRectangles& items() const { return items_; }
    const Notice& message() const { return message_; }
    const Log& log() const { return log_; }
    const ErrorDialog& error() const { return error_; }

  private:
    Application(std::shared_ptr<const Catalogue> catalogue, ApplicationOptions options);
    /// A scenario on its way from the thread that read it.
    struct Arrivals {
        std::mutex mutex;
        struct Arrival {
            Scenario scenario;
            std::filesystem::path file;
        };
        std::optional<Arrival> newest;
    };

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
    bool in_space();
    bool working();
    void take_messages();
    void note_what_is_missing();
    bool available(const std::string& choice) const;
    void use_quadratic_cells();
    void draw_remedy();
    void say(Notice notice);
    void arrange();
    void draw_menus();
    void draw_recent();
    void draw_toolbar();
    void draw_button(const Action& row);
    void draw_scenarios();
    void draw_sidebar();
    void draw_view(const PanelContext& context);
    void draw_plots(const FrameContext& context);
    void draw_edges();
    /// How a strip moves: to the sides or up and down, where its setting is 0, how far off it is 1.
    struct EdgeTravel {
        bool across = true;
        float zero = 0, span = 1;
    };
    void draw_edge(const char* name, const ItemRectangle& edge, const char* setting,
                   const EdgeTravel& travel);
    bool note_has_room() const;
    void draw_status();
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
    void move_in_history(bool forward);
    void record_edits();
    void fulfil(const PlotWish& wish);
    void export_files();
    void save_scenario();
    void open_scenario(const Scenario& scenario);
    void take_opening();
    void toggle_format(const std::string& name);
    void draw_formats();
    void open_builtin(const std::string& name);
    std::filesystem::path output_folder();

    std::shared_ptr<const Catalogue> catalogue_;
    std::filesystem::path output_;
    Settings settings_;
    std::shared_ptr<NoticeBoard> board_;
    std::shared_ptr<Arrivals> arrivals_ = std::make_shared<Arrivals>();
    Notice message_; ///< the last one, for the status line
    Log log_;
    ErrorDialog error_;
    OpenDialog open_dialog_;
    std::string closing_note_; ///< of the last end, which is in the log
    std::shared_ptr<const Mesh> looked_for_missing_;
    std::uint64_t openings_seen_ = 0;
    std::filesystem::path opening_file_;           ///< of the scenario on its way; empty: a built-in one
    std::vector<Scenario> shipped_;                ///< for the list of them, once it has been opened
    std::vector<Action> actions_ = make_actions(); ///< bound to this object
    ParameterPanel panel_;
    ItemRectangles items_;
    Layout layout_;
    Theme theme_;
    float scale_ = 1;
    std::shared_ptr<TessellationCache> tessellations_ = std::make_shared<TessellationCache>();
    ViewportPane viewport_pane_{tessellations_};
    PlotPane plot_pane_;
    ComparisonPanel comparison_panel_;
    RunList run_list_;
    std::optional<Plot> plot_picture_;
    std::string plot_name_; ///< of the file to come
    double wheeled_ = 0;       ///< when the wheel was last turned, by ImGui::GetTime()
    bool wheel_burst_ = false; ///< nothing else was done since
    bool quit_ = false, help_ = false, fullscreen_ = false;
    bool screenshot_ = false;        ///< asked for
    bool taking_screenshot_ = false; ///< this frame is the picture: it shows no tooltip
    BackgroundWriter writer_;
    Document document_; ///< last, so that its threads end before what they use
};

} // namespace gaspard
