// What the window does in a frame: panels, toolbar, shortcuts and messages around a document. All of it are
// ImGui calls and values, so it runs without a window and without OpenGL; who has both draws the pictures it
// asks for.
//
// The caller owns the ImGui context and its input; between ImGui::NewFrame() and ImGui::Render() it calls
// frame().
#pragma once

#include "gui/actions.hpp"
#include "gui/background_writer.hpp"
#include "gui/document.hpp"
#include "gui/item_rectangles.hpp"
#include "gui/layout.hpp"
#include "gui/parameter_panel.hpp"
#include "gui/plot_pane.hpp"
#include "gui/run_list.hpp"
#include "gui/theme.hpp"
#include "gui/viewport_pane.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace gaspard {

class Application {
  public:
    /// `wake` is called on other threads when there is something to collect. Exports and screenshots go into
    /// `output`/<scenario>.
    Application(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario, const Theme& theme,
                std::function<void()> wake, std::filesystem::path output = "gaspard-out");
    /// How much larger than the theme says everything is drawn, on displays of high density.
    void set_scale(float scale) { scale_ = scale; }

    /// Takes over what other threads have produced; true if there is something new to show.
    bool collect();
    /// Draws everything but the pictures of the meshes.
    void frame();
    /// A key as the table of actions writes it. Ignored while a text field has the keyboard. True if it did
    /// something.
    bool press_key(std::string_view key);
    void perform(ActionId id);

    const std::string& title() { return run().title; }
    bool quit_requested() const { return quit_; }
    /// True once after a screenshot was asked for; the answer is save_picture().
    bool take_screenshot_request() { return std::exchange(taking_screenshot_, false); }
    void save_picture(Image image);
    /// Saves the plot that was asked for, if any, as the picture that `draw` makes of it.
    void save_plot(const std::function<Image(const Plot&)>& draw);

    Document& document() { return document_; }
    /// The meshes that the last frame asks for.
    const std::vector<ShownPicture>& pictures() const { return viewport_pane_.pictures(); }
    const ItemRectangle& viewport_rectangle() const { return layout_.viewport; }
    const ItemRectangles& items() const { return items_; }
    const Notice& message() const { return message_; }

  private:
    DocumentRun& run() { return document_.runs().front(); }
    DocumentViewport& viewport() { return document_.viewports().front(); }
    bool possible(ActionId id);
    std::string label_of(const Action& action);
    void draw_menus();
    void draw_toolbar();
    void draw_button(const Action& row);
    void draw_scenarios();
    void draw_sidebar();
    void draw_status();
    void draw_help();
    void toggle_running();
    void export_files();
    void fulfil(const PlotWish& wish);
    void open_scenario(const std::string& name);
    std::filesystem::path output_folder();

    std::shared_ptr<const Catalogue> catalogue_;
    std::filesystem::path output_;
    std::shared_ptr<NoticeBoard> board_;
    Notice message_;
    std::uint64_t messages_seen_ = 0;
    ParameterPanel panel_;
    ItemRectangles items_;
    Layout layout_;
    Theme theme_;
    float scale_ = 1;
    ViewportPane viewport_pane_;
    PlotPane plot_pane_;
    RunList run_list_;
    std::optional<Plot> plot_picture_;
    std::string plot_name_; ///< of the file to come
    bool quit_ = false, help_ = false;
    bool screenshot_ = false;        ///< asked for
    bool taking_screenshot_ = false; ///< this frame is the picture: it shows no tooltip
    PictureWriter pictures_;
    Document document_; ///< last, so that its threads end before what they use
};

} // namespace gaspard
