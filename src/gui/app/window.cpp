#include "gui/app/window.hpp"

#include "core/base/error.hpp"
#include "gui/app/frame_pacing.hpp"
#include "gui/app/mesh_painter.hpp"
#include "gui/app/viewport_image.hpp"
#include "gui/app/whole_window.hpp"
#include "gui/app/window_events.hpp"
#include "gui/app/window_icon.hpp"
#include "gui/base/font_finder.hpp"
#include "gui/gl/gl.hpp"
#include "gui/gl/imgui_context.hpp"
#include "gui/gl/imgui_input.hpp"
#include "gui/plot/plot_image.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <backends/imgui_impl_glfw.h>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <imgui.h>
#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gaspard {

namespace {

constexpr int longest_wait = 30;                         // frames; then typed letters go to the focused item
constexpr double longest_step = 0.5, input_check = 0.01; // seconds, of what moves by itself

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text ? text : "no cause given";
}

bool is_set(const char* variable) {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0';
}

[[noreturn]] void report_no_display(const std::string& cause) {
    throw MachineError("No display: a window cannot be opened here (" + cause +
                       "); use `gaspard run`, which needs none");
}

class GlfwSession {
  public:
    GlfwSession() {
        // Without these GLFW 3.4 tries Wayland, whose library then prints messages of its own.
        if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY") && !is_set("WAYLAND_SOCKET"))
            report_no_display("neither DISPLAY nor WAYLAND_DISPLAY is set");
        if (!glfwInit()) report_no_display(last_glfw_error());
    }
    ~GlfwSession() { glfwTerminate(); }
    GlfwSession(const GlfwSession&) = delete;
    GlfwSession& operator=(const GlfwSession&) = delete;
};

struct DestroyWindow {
    void operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
};
using GlfwWindow = std::unique_ptr<GLFWwindow, DestroyWindow>;

/// The part of the screen that windows may use; empty if it is unknown.
ItemRectangle work_area() {
    int x = 0, y = 0, width = 0, height = 0;
    if (GLFWmonitor* screen = glfwGetPrimaryMonitor())
        glfwGetMonitorWorkarea(screen, &x, &y, &width, &height);
    return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(x + width),
            static_cast<float>(y + height)};
}

void keep_within_screen(GLFWwindow* window) {
    const ItemRectangle available = work_area();
    int width = 0, height = 0;
    glfwGetWindowSize(window, &width, &height);
    const int widest = static_cast<int>(available.width()), highest = static_cast<int>(available.height());
    if (widest > 0 && highest > 0 && (width > widest || height > highest))
        glfwSetWindowSize(window, std::min(width, widest), std::min(height, highest));
}

/// Moves the window to its last place if that is still on a screen.
void place_window(GLFWwindow* window, const Values& remembered) {
    if (!remembered.boolean("placed")) return;
    const auto x = static_cast<int>(remembered.integer("left")),
               y = static_cast<int>(remembered.integer("top"));
    int count = 0;
    GLFWmonitor** screens = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0, top = 0, width = 0, height = 0;
        glfwGetMonitorWorkarea(screens[i], &left, &top, &width, &height);
        if (x >= left && x + 100 < left + width && y >= top && y + 100 < top + height)
            return glfwSetWindowPos(window, x, y);
    }
}

/// Of several sizes, of which the desktop takes what fits.
void set_icon(GLFWwindow* window) {
    std::vector<Image> icons;
    for (const int size : {16, 32, 48, 128}) icons.push_back(window_icon(size));
    std::vector<GLFWimage> images;
    for (Image& icon : icons) images.push_back({icon.width, icon.height, icon.rgba.data()});
    glfwSetWindowIcon(window, static_cast<int>(images.size()), images.data());
}

GlfwWindow open_window(const std::string& title, const Values& remembered) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_MAXIMIZED, remembered.boolean("maximized") ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "gaspard"); // a desktop finds the entry with the icon by it
    glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "gaspard");
    // The size is for a display of scale 1; GLFW_SCALE_TO_MONITOR enlarges it on others.
    GlfwWindow window(glfwCreateWindow(static_cast<int>(remembered.integer("width")),
                                       static_cast<int>(remembered.integer("height")), title.c_str(), nullptr,
                                       nullptr));
    if (!window)
        throw MachineError("No OpenGL 3.3 for a window here (" + last_glfw_error() +
                           "); use `gaspard run`, which draws without one");
    set_icon(window.get());
    keep_within_screen(window.get());
    place_window(window.get(), remembered);
    glfwMakeContextCurrent(window.get());
    glfwSwapInterval(1);
    return window;
}

/// ImGui's GLFW backend, with an owner. Its callbacks are called by ours.
class ImGuiInput {
  public:
    explicit ImGuiInput(GLFWwindow* window) { ImGui_ImplGlfw_InitForOpenGL(window, false); }
    ~ImGuiInput() { ImGui_ImplGlfw_Shutdown(); }
    ImGuiInput(const ImGuiInput&) = delete;
    ImGuiInput& operator=(const ImGuiInput&) = delete;
};

/// The units of a window: `density` pixels per unit, and `zoom` units per unit of the theme.
struct Scales {
    float density = 1, zoom = 1;
    friend bool operator==(const Scales&, const Scales&) = default;
};

Scales scales_of(GLFWwindow* window) {
    int width = 0, pixels = 0, unused = 0;
    float content = 1, unused_too = 1;
    glfwGetWindowSize(window, &width, &unused);
    glfwGetFramebufferSize(window, &pixels, &unused);
    glfwGetWindowContentScale(window, &content, &unused_too);
    const float density =
        width > 0 && pixels > 0 ? static_cast<float>(pixels) / static_cast<float>(width) : 1.0F;
    return {density, std::clamp(content / density, 0.5F, 4.0F)};
}

struct Place {
    int x = 0, y = 0, width = 0, height = 0;
};

Place place_of(GLFWwindow* window) {
    Place place;
    glfwGetWindowPos(window, &place.x, &place.y);
    glfwGetWindowSize(window, &place.width, &place.height);
    return place;
}

/// A part of the window's image, opaque.
Image part_of(const Image& window, PixelRect part) {
    part.x = std::clamp(part.x, 0, window.width), part.y = std::clamp(part.y, 0, window.height);
    part.width = std::clamp(part.width, 0, window.width - part.x);
    part.height = std::clamp(part.height, 0, window.height - part.y);
    Image image{part.width, part.height, {}};
    for (int y = part.y; y < part.y + part.height; ++y) {
        const auto row = window.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * window.width + part.x);
        image.rgba.insert(image.rgba.end(), row, row + 4 * part.width);
    }
    for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
    return image;
}

class Window {
  public:
    Window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario, const WindowOptions& options)
        : window_(open_window("Gaspard", options.settings.window)),
          gl_(load_gl([](const char* name) { return reinterpret_cast<void*>(glfwGetProcAddress(name)); })) {
        input_.emplace(window_.get());
        note_events(window_.get(), happenings_);
        application_.emplace(std::move(catalogue), scenario,
                             ApplicationOptions{.wake = [this] { wake(happenings_.news); },
                                                .output = options.output,
                                                .named = options.named,
                                                .settings = options.settings,
                                                .complaints = options.complaints,
                                                .in_background = true});
        style();
        image_.emplace(gl_);
        start_drawing();
        stop_ = options.stop;
        wake_to_stop_.emplace(stop_, [this] { wake(happenings_.news); });
    }

    void loop() {
        while (!glfwWindowShouldClose(window_.get()) && !application_->window_state().quit &&
               !stop_.stop_requested()) {
            wait();
            // Before collecting, so that later news start another iteration.
            brings_news_ = happenings_.news.exchange(false);
            application_->collect();
            for (const auto& file : std::exchange(happenings_.dropped, {})) application_->open_file(file);
            if (fonts_.collect() || wanted_look() != look_) restyle();
            follow_fullscreen();
            if (const std::string& title = application_->title(); title != title_) {
                title_ = title;
                glfwSetWindowTitle(window_.get(), ("Gaspard: " + title).c_str());
                if (lacks_glyphs(*ImGui::GetIO().Fonts, title)) restyle();
            }
            draw();
        }
        remember_place();
        glfwHideWindow(window_.get()); // gone at once; the solver ends within its step
    }

    /// After the loop: the settings to be saved.
    Settings settings() {
        Settings settings = application_->settings();
        for (const auto& [key, value] : place_) settings.window.set(key, value);
        return settings;
    }

  private:
    /// Everything that determines the style of text and lines.
    struct Look {
        Scales scales;
        float text_size = 1;
        std::string theme;
        friend bool operator==(const Look&, const Look&) = default;
    };
    Look wanted_look() const {
        return {scales_of(window_.get()), application_->window_state().text_size,
                application_->window_state().theme_name};
    }
    /// Units of the window per unit of the theme.
    float zoom() const { return look_.scales.zoom * look_.text_size; }

    /// Called on other threads; once per frame is enough.
    static void wake(std::atomic<bool>& flag) {
        if (!flag.exchange(true)) glfwPostEmptyEvent();
    }

    /// The window's own context draws the meshes too, unless that would take its thread long.
    void start_drawing() {
        try {
            if (draws_in_software(gl_)) painter_.emplace([this] { wake(happenings_.image); });
        } catch (const MachineError&) { // then the window waits for its meshes
        }
        if (!painter_) meshes_.emplace(gl_);
    }

    /// Draws the meshes, or asks for them; and takes what is there. `shot`: this frame is to be an image, in
    /// full. Returns the seconds spent waiting.
    double draw_meshes(const WindowPixels& pixels, bool shot) {
        MeshesToDraw wanted = meshes_to_draw(*application_, pixels, zoom());
        image_->resize(pixels.width, pixels.height, wanted.theme.background);
        if (!painter_) {
            shot_ready_ = shot;
            if (wanted == drawn_) return 0;
            meshes_->draw(wanted);
            image_->take(*meshes_, wanted.area);
            drawn_ = std::move(wanted);
            return 0;
        }
        if (shot && shot_ready_) return 0; // with the meshes that came for it
        const bool at_once = pacing_.in_gesture(glfwGetTime()) || application_->window_state().animating;
        const bool in_full = shot || shot_number_;
        const auto number = painter_->want(wanted, in_full   ? Hurry::in_full
                                                   : at_once ? Hurry::at_once
                                                             : Hurry::none);
        if (shot) shot_number_ = number;
        const double begun = glfwGetTime();
        const bool there = wait_for_meshes();
        const double waited = glfwGetTime() - begun;
        if (there || !painted_) take_painted();
        const auto painted = std::exchange(painted_, nullptr);
        if (painted && in_same_place(painted->what, wanted)) {
            image_->take(*painted);
            drawn_ = painted->what;
            const bool for_shot = shot_number_ && painted->in_full && painted->number >= *shot_number_;
            if (for_shot && !shot) {
                shot_ready_ = true;
                application_->perform("screenshot"); // of the next frame, without a tooltip
                pacing_.need_more_frames();
            }
        } else if (drawn_ && !in_same_place(*drawn_, wanted)) {
            image_->forget_meshes(); // rather none than those of something else
            drawn_.reset();
        }
        if (shot && there) shot_ready_ = true;
        if (shot_ready_) shot_number_.reset();
        return waited;
    }

    void take_painted() {
        if (auto newer = painter_->take()) painted_ = std::move(newer);
    }

    /// Axes and marks belong to meshes. If a frame does not wait for its meshes, they stay with those that
    /// are there.
    void hold_overlay() {
        const bool late = painter_ && !keeps_step() && patience() == 0;
        if (late) take_painted();
        std::vector<ShownView> there;
        if (late && (painted_ || drawn_)) there = painted_ ? painted_->what.views : drawn_->views;
        application_->stay_with(std::move(there));
    }

    /// Seconds that a frame waits for its meshes. An input does not wait for what the solver has done
    /// meanwhile.
    double patience() const { return answers_input_ && brings_news_ ? 0 : painter_->patience(); }

    /// What moves by itself waits for its meshes.
    bool keeps_step() const {
        return application_->window_state().animating && !pacing_.in_gesture(glfwGetTime());
    }

    /// True if they are there. While a view moves by itself, frames keep step with its meshes rather than
    /// draw panels that have not changed and take the cores from the painter; an input ends that.
    bool wait_for_meshes() {
        if (!keeps_step()) return painter_->wait(patience());
        const double until = glfwGetTime() + longest_step;
        bool there = false;
        while (!there && !happenings_.input && glfwGetTime() < until) {
            there = painter_->wait(input_check);
            glfwPollEvents();
        }
        return there;
    }

    /// Sleeps until it is time for the next frame.
    void wait() {
        if (pacing_.may_sleep(causes())) glfwWaitEvents();
        for (double left = 0; (left = pacing_.rest(causes(), glfwGetTime())) > 0;)
            glfwWaitEventsTimeout(left);
        glfwPollEvents();
        pacing_.begin(causes(), glfwGetTime());
        answers_input_ = std::exchange(happenings_.input, false);
        happenings_.image = false;
    }

    FrameCauses causes() const {
        return {happenings_.input, happenings_.news, happenings_.image,
                application_->window_state().animating};
    }

    void style() {
        look_ = wanted_look();
        const float density = look_.scales.density;
        glfwSetWindowSizeLimits(window_.get(), std::lround(720 * look_.scales.zoom),
                                std::lround(540 * look_.scales.zoom), GLFW_DONT_CARE, GLFW_DONT_CARE);
        apply_theme(application_->window_state().theme, zoom());
        ImGuiIO& io = ImGui::GetIO();
        load_font(*io.Fonts, application_->window_state().theme,
                  zoom() * density, // as many pixels as it will cover
                  application_->title(), fonts_.fonts());
        fonts_.look_for(missing_characters(*io.Fonts, application_->title()));
        io.FontGlobalScale = 1 / density;
        application_->set_scale(zoom());
    }

    void restyle() {
        style();
        image_->interface().update_font();
        image_->draw_all_anew();
    }

    /// ImGui reads the state of keys and buttons once per frame. If frames are slow, there are more events
    /// than that: it gets as many as it can distinguish, and the rest in the following frames.
    void follow_input() {
        auto& inputs = happenings_.inputs;
        std::vector<int> pressed, released; // keys, in this frame
        bool commanded = false;             // by a key that types nothing
        waited_ = application_->window_state().awaits_text ? waited_ + 1 : 0;
        const auto wait_for_field = [&] {
            return application_->window_state().awaits_text && waited_ < longest_wait;
        };
        while (!inputs.empty() && !wait_for_field()) { // what follows is meant for the field
            if (const auto* key = std::get_if<KeyChange>(&inputs.front())) {
                const auto& opposite = key->down() ? released : pressed;
                if (std::count(opposite.begin(), opposite.end(), key->key) > 0) break;
                // It may be meant for what the command opens; and the command is with its own modifiers.
                if (commanded && (key->down() || key->modifies())) break;
                commanded = commanded || (key->down() && !key->only_types() && !key->modifies());
                feed(*key);
                (key->down() ? pressed : released).push_back(key->key);
            } else if (const auto* letter = std::get_if<Letter>(&inputs.front())) {
                if (commanded) break; // ImGui would take the letter first
                ImGui::GetIO().AddInputCharacter(letter->code);
            } else {
                break; // a button needs the position of the pointer at that time
            }
            inputs.pop_front();
        }
        follow_buttons();
        if (!inputs.empty()) pacing_.need_more_frames();
    }

    void feed(const KeyChange& change) {
        if (change.down()) application_->press_key(change.name);
        if (!change.down() || !change.only_types())
            ImGui_ImplGlfw_KeyCallback(window_.get(), change.key, change.scancode, change.event,
                                       change.modifiers);
        if (change.down() && (change.modifiers & GLFW_MOD_CONTROL) != 0)
            feed_control(ImGui::GetIO(), true); // the control key itself may not have been reported
    }

    /// Passes one position of the pointer and at most one change of a button per frame, as ImGui expects.
    void follow_buttons() {
        ImGuiIO& io = ImGui::GetIO();
        auto& inputs = happenings_.inputs;
        if (const auto* change = inputs.empty() ? nullptr : std::get_if<ButtonChange>(&inputs.front())) {
            const bool dragged = !change->down && (change->at.x != pointer_.x || change->at.y != pointer_.y);
            pointer_ = change->at;
            if (!dragged) { // else it is released in the next frame
                buttons_[static_cast<std::size_t>(change->button)] = change->down;
                inputs.pop_front();
            }
            pacing_.need_more_frames();
        } else {
            pointer_ = happenings_.pointer;
        }
        feed_pointer(io, pointer_);
        std::copy(buttons_.begin(), buttons_.end(), io.MouseDown);
    }

    void follow_fullscreen() {
        const bool full = glfwGetWindowMonitor(window_.get()) != nullptr;
        if (full == application_->window_state().fullscreen) return;
        if (full) {
            glfwSetWindowMonitor(window_.get(), nullptr, before_.x, before_.y, before_.width, before_.height,
                                 GLFW_DONT_CARE);
            return;
        }
        before_ = place_of(window_.get());
        GLFWmonitor* screen = glfwGetPrimaryMonitor();
        const GLFWvidmode* mode = screen ? glfwGetVideoMode(screen) : nullptr;
        if (mode)
            glfwSetWindowMonitor(window_.get(), screen, 0, 0, mode->width, mode->height, mode->refreshRate);
    }

    /// After full screen the window has its previous size.
    void remember_place() {
        const bool full = glfwGetWindowMonitor(window_.get()) != nullptr;
        const bool maximized = glfwGetWindowAttrib(window_.get(), GLFW_MAXIMIZED) != 0;
        place_["maximized"] = maximized;
        if (maximized) return;
        const Place now = full ? before_ : place_of(window_.get());
        place_["placed"] = true;
        const auto remember = [this](const char* key, float value) {
            place_[key] = std::int64_t{
                std::lround(within(application_->settings().window, key, static_cast<double>(value)))};
        };
        remember("left", static_cast<float>(now.x));
        remember("top", static_cast<float>(now.y));
        remember("width", static_cast<float>(now.width) / look_.scales.zoom);
        remember("height", static_cast<float>(now.height) / look_.scales.zoom);
    }

    /// `again`: for the same drawing.
    void lay_out(bool again) {
        ImGui_ImplGlfw_NewFrame();
        follow_input();
        // ImGui notices a click one frame later, so a double click takes up to four frames.
        if (!again) ImGui::GetIO().MouseDoubleClickTime = std::max(0.3F, 4 * ImGui::GetIO().DeltaTime);
        hold_overlay();
        ImGui::NewFrame();
        application_->frame();
        ImGui::Render();
    }

    void draw() {
        int width = 0, height = 0;
        glfwGetFramebufferSize(window_.get(), &width, &height);
        if (width <= 0 || height <= 0) return; // minimized
        lay_out(false);
        bool shot = application_->take_screenshot_request();
        if (answers_input_ && !shot) { // what a panel changes, those before it show one frame later
            lay_out(true);
            shot = application_->take_screenshot_request();
        }
        const WindowPixels pixels{width, height, look_.scales.density};
        const double waited = draw_meshes(pixels, shot);
        const bool exposed = std::exchange(happenings_.exposed, false);
        const bool changed = image_->draw(pixels);
        if (shot && std::exchange(shot_ready_, false))
            application_->save_image(
                part_of(image_->read(), pixels_of(application_->viewport_rectangle(), look_.scales.density)));
        if (changed || exposed) image_->show();
        application_->save_plot([this](const Plot& plot) {
            return draw_plot_image(gl_, image_->interface(), plot, application_->window_state().theme, zoom(),
                                   look_.scales.density);
        });
        gl_.Finish();
        pacing_.end(glfwGetTime() - pacing_.begun() - waited, changed); // without waiting for the screen
        if (changed || exposed) glfwSwapBuffers(window_.get());
    }

    // Destroyed in the opposite order: the solver first, the display last.
    GlfwSession session_;
    Happenings happenings_;
    GlfwWindow window_;
    Gl gl_;
    ImGuiSession imgui_;
    std::optional<ImGuiInput> input_;
    std::optional<WindowImage> image_;
    std::optional<MeshPainter> painter_; ///< or, with a graphics card:
    std::optional<MeshImage> meshes_;
    std::optional<MeshesToDraw> drawn_;            ///< what the window shows
    std::shared_ptr<const PaintedMeshes> painted_; ///< taken for this frame, to be shown in it
    std::optional<std::uint64_t> shot_number_{};   ///< of the meshes that an image of the window waits for
    bool shot_ready_ = false;                      ///< they are there
    Look look_;
    Place before_;                       ///< the window filled the screen
    std::map<std::string, Value> place_; ///< where it stood when it was closed, as in the settings
    std::string title_;                  ///< of what is shown
    int waited_ = 0;                     ///< frames, for a dialog's field
    ImVec2 pointer_;                     ///< in the last frame, like the buttons
    std::array<bool, ImGuiMouseButton_COUNT> buttons_{};
    FramePacing pacing_;
    bool answers_input_ = false, brings_news_ = false; ///< the frame that is being drawn
    FontFinder fonts_{[this] { wake(happenings_.news); }};
    std::optional<Application> application_;
    std::stop_token stop_;
    std::optional<std::stop_callback<std::function<void()>>> wake_to_stop_; ///< on the thread that stops
};

} // namespace

Settings run_window(std::shared_ptr<const Catalogue> catalogue, const Scenario& scenario,
                    const WindowOptions& options) {
    Window window(std::move(catalogue), scenario, options);
    window.loop();
    return window.settings();
}

} // namespace gaspard
