#include "gui/app/viewport_image.hpp"

#include "core/base/check.hpp"
#include "core/base/error.hpp"
#include "core/scenario/view_rows.hpp"
#include "gui/app/strips.hpp"
#include "gui/gl/imgui_context.hpp"
#include "gui/gl/imgui_renderer.hpp"
#include "gui/plot/plot_widget.hpp"
#include "gui/render/mesh_renderer.hpp"
#include "gui/viewport/legend.hpp"
#include "gui/viewport/viewport.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace gaspard {

namespace {

/// Text grows with the image, but stays readable in a small one.
float image_scale(int width, int height) {
    return std::clamp(std::min(static_cast<float>(width) / 1000, static_cast<float>(height) / 750), 0.75F,
                      10.0F);
}

/// On a background of one colour the theme is the one that is legible there.
Theme theme_of(const ImageOptions& options) {
    const auto [r, g, b] = options.background.colour;
    const bool chosen = options.background.kind == Background::Kind::colour;
    const bool light = chosen ? 299 * r + 587 * g + 114 * b > 500 * 255 : options.light;
    Theme theme = light ? light_theme() : dark_theme();
    const auto part = [](unsigned char value) { return static_cast<float>(value) / 255; };
    if (chosen) theme.background = {part(r), part(g), part(b), 1};
    if (options.background.kind == Background::Kind::transparent) theme.background.a = 0;
    return theme;
}

/// Drawn over nothing, colours are multiplied by their alpha; a PNG has them straight.
void divide_by_alpha(Image& image) {
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const int alpha = image.rgba[i + 3];
        for (std::size_t k = i; alpha > 0 && k < i + 3; ++k)
            image.rgba[k] =
                static_cast<std::uint8_t>(std::min(255, (image.rgba[k] * 255 + alpha / 2) / alpha));
    }
}

Values view_of(const MeshPanel& panel) {
    const auto& fields = panel.snapshot->fields;
    Values view("view", view_rows(std::vector<FieldInfo>(fields.begin(), fields.end())));
    view.set("color", panel.colour);
    view.set("blend", panel.blend);
    view.set("camera", panel.camera);
    view.set("cut", panel.cut);
    view.set("lines", panel.lines);
    view.set("histogram", false);
    view.set("axes", false);
    return view;
}

/// What the program itself draws of a size: layout and texts, in an ImGui context of its own. The meshes, and
/// everything of OpenGL, come later, perhaps on another thread.
class Page {
  public:
    /// `text`: what will be written that is not the program's own, such as titles.
    Page(int width, int height, float scale, const ImageOptions& options, std::string_view text)
        : theme_(theme_of(options)), scale_(scale), width_(width), height_(height),
          step_(strip_height(width, height, options.most_pixels)), cache_(options.cache),
          prepared_(options.planner) {
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
        io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset; // as ImGuiRenderer does
        load_font(*io.Fonts, theme_, scale, text);
        apply_theme(theme_, scale);
        font_ = pixels_of(*io.Fonts);
        ImGui::NewFrame();
    }

    /// The width of its legend.
    float legend_of(const MeshPanel& panel) const {
        const Values view = view_of(panel);
        const auto colouring = make_colouring(*panel.snapshot, colour_choice(view));
        return colouring ? legend_width(*colouring, view.boolean("histogram"), scale_) : 0;
    }

    void mesh(const Snapshot& snapshot, const Values& view, const ViewportText& text, PixelRect area,
              const std::vector<NamedSnapshot>& beside = {}) {
        auto planner = std::exchange(prepared_, nullptr);
        if (!planner)
            planner =
                cache_ ? std::make_shared<ViewportPlanner>(cache_) : std::make_shared<ViewportPlanner>();
        ViewportPlan plan = planner->plan(snapshot, view, text, on_screen(area), scale_, beside);
        draw_viewport_plots(*ImGui::GetBackgroundDrawList(), plan, theme_, scale_);
        draw_viewport_overlay(*ImGui::GetBackgroundDrawList(), plan, theme_, scale_);
        std::move(plan.views.begin(), plan.views.end(), std::back_inserter(views_));
    }

    void plot(const Plot& plot, PixelRect area) {
        ScreenRect rect = on_screen(area);
        const float margin = 14 * scale_;
        rect.min = {rect.min.x + margin, rect.min.y + margin / 2};
        rect.max = {rect.max.x - margin, rect.max.y - margin / 2};
        draw_plot(*ImGui::GetBackgroundDrawList(), plot, rect, theme_, scale_);
    }

    /// Ends the layout; what was the current ImGui context before is it again.
    void close() {
        ImGui::Render();
        for (int top = 0; top < height_; top += step_)
            texts_.push_back(in_strip(*ImGui::GetDrawData(), {top, step_}));
        session_.leave();
    }

    /// Of a page that was closed. Uses no ImGui context. `drawn`: called with the fraction that is done.
    Image draw(const Gl& gl, const std::stop_token& stop, const std::function<void(double)>& drawn) const {
        const RenderTarget target(gl, width_, step_);
        MeshRenderer meshes(gl);
        ImGuiRenderer texts(gl, font_);
        Image image = draw_in_strips(width_, height_, step_, [&](Strip strip) {
            if (drawn) drawn(static_cast<double>(strip.top) / height_);
            target.bind();
            clear(gl);
            const auto& text = texts_[static_cast<std::size_t>(strip.top / step_)];
            strip.height = step_; // the last one may be cut off below the image
            for (const PlannedView& shown : views_)
                if (const auto part = in_strip(shown.camera, in_pixels(shown.rect), strip)) {
                    if (stop.stop_requested()) throw Interrupted();
                    meshes.draw(shown.scene, part->camera, part->area, step_, theme_, scale_);
                }
            texts.draw(text);
            return target.read();
        });
        if (theme_.background.a < 1) divide_by_alpha(image);
        return image;
    }

  private:
    void clear(const Gl& gl) const {
        const Colour ground = theme_.background;
        gl.Disable(GL_SCISSOR_TEST);
        gl.ClearColor(ground.r * ground.a, ground.g * ground.a, ground.b * ground.a, ground.a);
        gl.Clear(GL_COLOR_BUFFER_BIT);
    }

    static ScreenRect on_screen(PixelRect area) {
        const auto x = static_cast<float>(area.x), y = static_cast<float>(area.y);
        return {{x, y}, {x + static_cast<float>(area.width), y + static_cast<float>(area.height)}};
    }

    static PixelRect in_pixels(ScreenRect rect) {
        const auto pixel = [](float position) { return static_cast<int>(std::lround(position)); };
        return {pixel(rect.min.x), pixel(rect.min.y), pixel(rect.width()), pixel(rect.height())};
    }

    Theme theme_;
    float scale_;
    int width_, height_; ///< of the image
    int step_;           ///< height of a strip of it
    std::shared_ptr<TessellationCache> cache_;
    std::shared_ptr<ViewportPlanner> prepared_; ///< of the first mesh; may be null
    ImGuiSession session_;
    FontPixels font_;
    std::vector<PlannedView> views_;
    std::vector<ImDrawData> texts_; ///< per strip
};

/// With the caller's context, or one that is made for it.
Image draw_page(const Page& page, const ImageOptions& options,
                const std::function<void(double)>& drawn = {}) {
    if (options.gl != nullptr) return page.draw(*options.gl, options.stop, drawn);
    const auto context = make_offscreen_context(options.backend);
    return page.draw(context->gl(), options.stop, drawn);
}

std::unique_ptr<Page> page_of_view(const Snapshot& snapshot, const Values& view, int width, int height,
                                   const std::string& subject, const ImageOptions& options) {
    ImageOptions themed = options;
    themed.light = options.light || view.text("theme") == "light";
    themed.background = parse_background(view.text("background"));
    const float scale = image_scale(width, height) * static_cast<float>(view.real("text_size"));
    auto page = std::make_unique<Page>(width, height, scale, themed, subject);
    const ViewportText text{.subject = subject,
                            .report = snapshot.report,
                            .last_iteration = options.last_iteration,
                            .caption = view.boolean("caption"),
                            .with_legend = view.boolean("legend"),
                            .notes = view.boolean("note")};
    page->mesh(snapshot, view, text, {0, 0, width, height}, options.beside);
    page->close();
    return page;
}

} // namespace

Image render_view(const Snapshot& snapshot, const Values& view, int width, int height,
                  const std::string& subject, const ImageOptions& options) {
    return draw_page(*page_of_view(snapshot, view, width, height, subject, options), options);
}

struct PreparedImage::Parts {
    std::unique_ptr<Page> page;
    ImageOptions options;
};

PreparedImage::PreparedImage(const Snapshot& snapshot, const Values& view, int width, int height,
                             const std::string& subject, const ImageOptions& options)
    : parts_(std::make_unique<Parts>(
          Parts{page_of_view(snapshot, view, width, height, subject, options), options})) {
    parts_->options.beside.clear(); // they are needed no longer, and may go
    parts_->options.planner.reset();
}

PreparedImage::~PreparedImage() = default;

Image PreparedImage::draw(const std::function<void(double)>& drawn) const {
    return draw_page(*parts_->page, parts_->options, drawn);
}

Image render_plot(const Plot& plot, int width, int height, const ImageOptions& options) {
    Page page(width, height, image_scale(width, height), options, plot.title);
    page.plot(plot, {0, 0, width, height});
    page.close();
    return draw_page(page, options);
}

Image render_panels(const std::vector<Panel>& panels, int columns, int width, int height,
                    const ImageOptions& options) {
    GASPARD_CHECK(columns > 0 && !panels.empty());
    const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
    const int panel_width = width / columns, panel_height = height / rows;
    std::string titles;
    for (const Panel& panel : panels)
        titles += std::visit([](const auto& shown) { return shown.title; }, panel);
    Page page(width, height, image_scale(panel_width * 3 / 2, panel_height * 3 / 2), options, titles);
    float legend = 0;
    for (const Panel& panel : panels)
        if (const auto* mesh = std::get_if<MeshPanel>(&panel))
            legend = std::max(legend, page.legend_of(*mesh));
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const int at = static_cast<int>(i);
        const PixelRect area{at % columns * panel_width, at / columns * panel_height, panel_width,
                             panel_height};
        if (const auto* plot = std::get_if<Plot>(&panels[i])) {
            page.plot(*plot, area);
            continue;
        }
        const auto& panel = std::get<MeshPanel>(panels[i]);
        page.mesh(*panel.snapshot, view_of(panel), {.title = panel.title, .caption = false, .legend = legend},
                  area);
    }
    page.close();
    return draw_page(page, options);
}

} // namespace gaspard
