#include "gui/render/mesh_renderer.hpp"

#include "core/base/check.hpp"
#include "core/tessellate/coarse_tessellation.hpp"
#include "gui/render/colour_place.hpp"
#include "gui/scene/clip_matrix.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace gaspard {

namespace {

constexpr std::size_t most_when_moving = 30'000; // triangles, of curved cells

// In pixels at scale 1.
constexpr float line_cell_width = 9, disc_width = 4.5F, rimmed_disc_width = 7;
// A tangled cell, however small, is drawn as a magenta dot in a ring of the text's colour in a ring of the
// background's colour. On every colour map at least two of the three are clearly visible.
constexpr float tangled_width = 5, tangled_ring_width = 8, tangled_rim_width = 11;
constexpr float few_tangled = 20, tangled_opacity = 0.45F;
constexpr float arrow_shaft_width = 0.8F, arrow_head_width = 3, arrow_rim_width = 1;
constexpr float arrow_pull = 0.06F; // of half the view's depth
// Lines that are closer than `begin` are not drawn; at distances above `end` they are opaque. `haze` is the
// strength of the uniform tint that replaces lines that are not drawn. Without colours, only lines show how
// dense a mesh is; with colours, lines must not hide them.
struct Fading {
    float begin, end, haze;
};
constexpr Fading plain_fading{1.5F, 3.8F, 1}, coloured_fading{1.6F, 5.5F, 0.015F};
constexpr float pull_pixels = 2;
constexpr double smallest_facet = 9; // pixels of a triangle, on average, to be drawn with its edges
constexpr float contour_width = 1.5F;
constexpr float overlay_width = 1, overlay_pull = 0.004F; // the second of half the view's depth
constexpr float dusk = 0.42F, dusk_of_caps = 0.16F;       // as in mesh_fill.frag
constexpr float bent = 0.3F;                              // as in mesh_line.vert
constexpr float limb_begin = 0.04F, limb_end = 0.5F;

void set_colour(const Gl& gl, GLint where, Colour c) { gl.Uniform4f(where, c.r, c.g, c.b, c.a); }

glm::vec3 single(Vec3 v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

float logarithm_of(const MeshScene& scene) {
    if (scene.colouring == nullptr || !scene.colouring->range.logarithmic) return 0;
    return static_cast<float>(std::log(scene.colouring->range.high / scene.colouring->range.low));
}

} // namespace

MeshRenderer::MeshRenderer(const Gl& gl)
    : gl_(gl), fill_program_(make_program(gl, "mesh_fill")), line_program_(make_program(gl, "mesh_line")),
      arrow_program_(make_program(gl, "arrow")), tangled_array_(gl), empty_array_(gl), tangled_triangles_(gl),
      cells_(gl), coarse_(gl), colours_(gl), layer_(gl), draft_(gl) {
    const auto fill = [&](const char* name) { return uniform(gl, fill_program_, name); };
    const auto line = [&](const char* name) { return uniform(gl, line_program_, name); };
    const auto arrow = [&](const char* name) { return uniform(gl, arrow_program_, name); };
    fill_ = {fill("clip"),          fill("blend"),      fill("clip_to_pixels"), fill("surface"),
             fill("logarithm"),     fill("flat_cells"), fill("ball"),           fill("viewer"),
             fill("round_cells"),   fill("dusk"),       fill("nodal"),          fill("pallor"),
             fill("first_triangle")};
    line_ = {line("clip"),    line("blend"),      line("half_viewport"), line("half_width"),
             line("fade"),    line("haze"),       line("pieces"),        line("pull"),
             line("surface"), line("flat_ink"),   line("ink_on_light"),  line("logarithm"),
             line("by_map"),  line("flat_cells"), line("ball"),          line("viewer"),
             line("limb"),    line("bent")};
    arrow_ = {arrow("clip"),      arrow("half_viewport"), arrow("head_width"), arrow("shaft_width"),
              arrow("rim_width"), arrow("pull"),          arrow("ink"),        arrow("rim")};
    for (const GlProgram* program : {&fill_program_, &line_program_, &arrow_program_}) {
        gl.UseProgram(program->name());
        gl.Uniform1i(uniform(gl, *program, "computational"), mesh_unit::computational);
        gl.Uniform1i(uniform(gl, *program, "physical"), mesh_unit::physical);
        gl.Uniform1i(uniform(gl, *program, "colours"), mesh_unit::colours);
        gl.Uniform1i(uniform(gl, *program, "segments"), mesh_unit::segments);
        gl.Uniform1i(uniform(gl, *program, "shown_cells"), mesh_unit::cells);
        gl.Uniform1i(uniform(gl, *program, "cell_values"), mesh_unit::cell_values);
        gl.Uniform1i(uniform(gl, *program, "facets"), mesh_unit::facets);
    }
    gl.BindVertexArray(tangled_array_.name());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, tangled_triangles_.name());
}

MeshRenderer::CellSet::CellSet(const Gl& gl) : array(gl), triangles(gl) {
    gl.BindVertexArray(array.name());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles.name());
}

void MeshRenderer::fill(TexelTable& table, const TexelFormat& format, const void* texels, std::size_t count) {
    uploaded_bytes_ += table.fill(gl_, format, texels, count);
}

void MeshRenderer::upload_points(const Points& points, const MeshScene& scene, bool with_values,
                                 TexelTable& table) {
    texels_.resize(points.size());
    const double *x = points.x.data(), *y = points.y.data(), *z = points.z.data();
    for (std::size_t i = 0; i < texels_.size(); ++i)
        texels_[i] = {static_cast<float>(x[i] - centre_.x), static_cast<float>(y[i] - centre_.y),
                      static_cast<float>(z[i] - centre_.z), 0};
    if (with_values && scene.point_values != nullptr) {
        const ColourPlace place(scene.colouring->range);
        const double* values = scene.point_values->data();
        for (std::size_t i = 0; i < texels_.size(); ++i) texels_[i].a = place.of(values[i]);
    }
    fill(table, four_floats, texels_.data(), texels_.size());
}

void MeshRenderer::upload_cell_values(const MeshScene& scene) {
    const ColourPlace place(scene.colouring->range);
    const std::vector<double>& values = scene.colouring->values;
    numbers_.resize(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) numbers_[i] = place.of(values[i]);
    fill(cell_values_, one_float, numbers_.data(), numbers_.size());
}

void MeshRenderer::upload_numbers(TexelTable& table, const std::vector<std::uint32_t>& numbers) {
    fill(table, one_number, numbers.data(), numbers.size());
}

void MeshRenderer::upload_triangles(const GlVertexArray& array, const std::vector<std::uint32_t>& triangles) {
    const std::size_t bytes = triangles.size() * sizeof(std::uint32_t);
    gl_.BindVertexArray(array.name());
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), triangles.data(), GL_STATIC_DRAW);
    uploaded_bytes_ += bytes;
}

void MeshRenderer::upload_segments(LineSet& set, const std::vector<Segment>& segments) {
    set.count = segments.size();
    fill(set.table, four_numbers, segments.data(), segments.size());
}

void MeshRenderer::upload_overlay(const MeshScene& scene, bool new_centre) {
    if (scene.overlay == nullptr || (scene.overlay == overlay_ && !new_centre)) return;
    if (overlay_ == nullptr || scene.overlay->tessellation != overlay_->tessellation)
        upload_segments(overlay_edges_, segments_of(*scene.overlay->tessellation));
    upload_points(*scene.overlay->points, scene, false, overlay_points_);
    overlay_ = scene.overlay;
}

void MeshRenderer::upload_contours(const MeshScene& scene) {
    std::vector<Segment> on_dark, on_light;
    if (scene.contours != nullptr) {
        const MeshContours& contours = *scene.contours;
        upload_points(contours.computational, scene, false, contours_computational_);
        upload_points(contours.physical, scene, false, contours_physical_);
        const Colouring& colouring = *scene.colouring;
        for (std::uint32_t i = 0; i < contours.values.size(); i += 2) {
            const double place = colouring.range.position(contours.values[i]);
            (is_dark(colour_at(*colouring.map, place)) ? on_dark : on_light).push_back({i, i + 1, i, i});
        }
    }
    upload_segments(contours_on_dark_, on_dark);
    upload_segments(contours_on_light_, on_light);
}

void MeshRenderer::upload_cells(const Tessellation& tessellation, const MeshScene& scene, CellSet& set) {
    const CellShape shape = scene.mesh->kind.shape;
    set.parts =
        make_facets(tessellation, shape == CellShape::quadrilateral || shape == CellShape::hexahedron);
    fill(set.facets, four_numbers, set.parts.facets.data(), set.parts.facets.size());
    upload_triangles(set.array, set.parts.corners);
    upload_segments(set.edges, segments_of(tessellation));
    upload_numbers(set.cells,
                   scene.cell_dimension == 1 ? tessellation.segment_cells : tessellation.triangle_cells);
    set.caps = 3 * tessellation.caps;
    set.cuts = tessellation.cuts;
    upload_segments(set.border, segments_at_borders(tessellation));
}

void MeshRenderer::upload_structure(const MeshScene& scene) {
    const Tessellation& tessellation = *scene.tessellation;
    upload_cells(tessellation, scene, cells_);
    std::vector<Segment> discs;
    if (scene.cell_dimension == 1)
        for (std::uint32_t p = 0; p < tessellation.point_count; ++p) discs.push_back({p, p, p, p});
    upload_segments(discs_, discs);
}

void MeshRenderer::upload_sides(const Tessellation& tessellation, CellSet& set) {
    if (set.cuts > 1) upload_numbers(set.sides, sides_on_segments(set.parts, tessellation));
}

/// Of the scene that is on the card.
const MeshRenderer::CellSet& MeshRenderer::cells_for(bool quickly) {
    if (!quickly || shown_.cell_dimension == 1) return cells_;
    if (shown_.tessellation != coarse_of_) {
        coarse_of_ = shown_.tessellation;
        const CellShape shape = shown_.mesh->kind.shape;
        const bool triangles = shape == CellShape::triangle;
        const auto coarse = coarsened(*coarse_of_, triangles ? 3 : 4, most_when_moving);
        is_coarse_ = coarse.has_value();
        if (coarse) upload_cells(*coarse, shown_, coarse_);
        coarse ? upload_sides(*coarse, coarse_) : upload_sides(*coarse_of_, cells_);
    }
    return is_coarse_ ? coarse_ : cells_;
}

void MeshRenderer::upload_tangled(const MeshScene& scene) {
    std::vector<std::uint32_t> triangles;
    std::vector<Segment> outlines;
    if (scene.tangled != nullptr) {
        const Tessellation& t = *scene.tessellation;
        std::vector<char> marked(scene.tangled->back() + std::size_t{1}, 0);
        for (const std::uint32_t cell : *scene.tangled) marked[cell] = 1;
        for (std::size_t i = 0; i < t.segment_cells.size(); ++i)
            if (t.segment_cells[i] < marked.size() && marked[t.segment_cells[i]] != 0)
                outlines.push_back(
                    {t.segments[2 * i], t.segments[2 * i + 1], t.segments[2 * i], t.segments[2 * i]});
        for (std::size_t i = 0; i < t.triangle_cells.size(); ++i) {
            if (t.triangle_cells[i] >= marked.size() || marked[t.triangle_cells[i]] == 0) continue;
            for (std::size_t k = 0; k < 3; ++k) triangles.push_back(cells_.parts.corners[3 * i + k]);
        }
        for (const auto& loop : cell_outlines(t, *scene.tangled))
            for (std::size_t k = 0; k < loop.size(); ++k) { // the opposite side of the cell is beside it
                const std::uint32_t across = loop[(k + loop.size() / 2) % loop.size()];
                outlines.push_back({loop[k], loop[(k + 1) % loop.size()], across, across});
            }
    }
    tangled_count_ = triangles.size();
    upload_triangles(tangled_array_, triangles);
    upload_segments(outlines_, outlines);
}

void MeshRenderer::upload_colours(const ColourMap& map) {
    const auto& colours = map.colours;
    std::vector<unsigned char> texels;
    for (const auto& c : colours) texels.insert(texels.end(), {c[0], c[1], c[2], 255});
    gl_.ActiveTexture(GL_TEXTURE0 + mesh_unit::colours);
    gl_.BindTexture(GL_TEXTURE_2D, colours_.name());
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, static_cast<GLsizei>(colours.size()), 1, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, texels.data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    uploaded_bytes_ += texels.size();
}

void MeshRenderer::upload(const MeshScene& scene) {
    const bool new_structure = scene.tessellation != shown_.tessellation;
    const bool new_computational = scene.computational != shown_.computational;
    if (new_structure) upload_structure(scene);
    if (new_computational) {
        centre_ = bounding_box(*scene.computational).centre();
        upload_points(*scene.computational, scene, false, computational_);
    }
    const bool new_colouring = scene.colouring != shown_.colouring;
    if (new_computational || new_colouring || scene.physical != shown_.physical)
        upload_points(*scene.physical, scene, true, physical_);
    if (new_colouring && scene.flat()) upload_cell_values(scene);
    if (new_structure || scene.tangled != shown_.tangled) upload_tangled(scene);
    if (new_computational || new_colouring || scene.contours != shown_.contours) upload_contours(scene);
    upload_overlay(scene, new_computational);
    if (scene.arrows != nullptr && scene.arrows != shown_.arrows) upload_numbers(arrows_, *scene.arrows);
    if (scene.colouring != nullptr && scene.colouring->map != map_) {
        map_ = scene.colouring->map;
        upload_colours(*map_);
    }
    shown_ = scene;
}

void MeshRenderer::clear(PixelRect area, int bottom, const Theme& theme) {
    gl_.Viewport(area.x, bottom, area.width, area.height);
    gl_.Scissor(area.x, bottom, area.width, area.height);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.DepthMask(GL_TRUE);
    const Colour ground = theme.background;
    gl_.ClearColor(ground.r * ground.a, ground.g * ground.a, ground.b * ground.a, ground.a);
    gl_.ClearDepth(1);
    gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gl_.Disable(GL_CULL_FACE);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void MeshRenderer::bind_points(const TexelTable& computational, const TexelTable& physical) {
    computational.bind(gl_, mesh_unit::computational);
    physical.bind(gl_, mesh_unit::physical);
}

void MeshRenderer::bind_cells(const CellSet& set) {
    set.cells.bind(gl_, mesh_unit::cells);
    set.facets.bind(gl_, mesh_unit::facets);
}

void MeshRenderer::bind_tables() {
    bind_points(computational_, physical_);
    gl_.ActiveTexture(GL_TEXTURE0 + mesh_unit::colours);
    gl_.BindTexture(GL_TEXTURE_2D, colours_.name());
    cell_values_.bind(gl_, mesh_unit::cell_values);
    bind_cells(*drawn_);
}

void MeshRenderer::draw_fill(const Frame& frame, const FillPart& part) {
    if (part.count == 0) return;
    gl_.UseProgram(fill_program_.name());
    gl_.UniformMatrix4fv(fill_.clip, 1, GL_FALSE, glm::value_ptr(frame.clip));
    gl_.Uniform1f(fill_.blend, frame.blend);
    gl_.Uniform3f(fill_.clip_to_pixels, frame.clip_to_pixels.x, frame.clip_to_pixels.y,
                  frame.clip_to_pixels.z);
    set_colour(gl_, fill_.surface, part.surface);
    gl_.Uniform1f(fill_.logarithm, frame.logarithm);
    gl_.Uniform1i(fill_.flat_cells, shown_.flat() ? 1 : 0);
    gl_.Uniform4f(fill_.ball, frame.ball.x, frame.ball.y, frame.ball.z, frame.ball.w);
    gl_.Uniform3f(fill_.viewer, frame.viewer.x, frame.viewer.y, frame.viewer.z);
    gl_.Uniform1i(fill_.round_cells, is_round() ? 1 : 0);
    gl_.Uniform1f(fill_.dusk, frame.planar ? 0 : part.dusk);
    gl_.Uniform1f(fill_.pallor, part.pallor);
    gl_.Uniform1i(fill_.first_triangle, static_cast<GLint>(part.first / 3));
    gl_.Uniform1i(fill_.nodal, shown_.point_values != nullptr && !shown_.flat() ? 1 : 0);
    gl_.BindVertexArray(part.array.name());
    gl_.DrawElements(GL_TRIANGLES, static_cast<GLsizei>(part.count), GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(part.first * sizeof(std::uint32_t)));
}

/// All cells; where planes cut a solid, its caps in full colour and the rest paler.
void MeshRenderer::draw_cells(const Frame& frame, Colour surface) {
    const std::size_t all = drawn_->parts.corners.size(), caps = drawn_->caps;
    draw_fill(frame, {drawn_->array, 0, all - caps, surface, dusk, caps > 0 ? 1.0F : 0.0F});
    draw_fill(frame, {drawn_->array, all - caps, caps, surface, dusk_of_caps, 0});
}

void MeshRenderer::draw_lines(const Frame& frame, const LineSet& set, const LineStyle& style) {
    if (set.count == 0) return;
    gl_.UseProgram(line_program_.name());
    set.table.bind(gl_, mesh_unit::segments);
    gl_.UniformMatrix4fv(line_.clip, 1, GL_FALSE, glm::value_ptr(frame.clip));
    gl_.Uniform1f(line_.blend, frame.blend);
    gl_.Uniform2f(line_.half_viewport, frame.clip_to_pixels.x, frame.clip_to_pixels.y);
    gl_.Uniform1f(line_.half_width, style.width / 2);
    gl_.Uniform2f(line_.fade, style.fade_begin, style.fade_end);
    gl_.Uniform1f(line_.haze, style.haze);
    gl_.Uniform1f(line_.pieces, static_cast<float>(drawn_->cuts));
    gl_.Uniform1f(line_.pull, style.pull);
    set_colour(gl_, line_.surface, style.surface);
    set_colour(gl_, line_.flat_ink, style.flat_ink);
    set_colour(gl_, line_.ink_on_light, style.ink_on_light);
    gl_.Uniform1f(line_.logarithm, frame.logarithm);
    gl_.Uniform4f(line_.ball, frame.ball.x, frame.ball.y, frame.ball.z, frame.ball.w);
    gl_.Uniform3f(line_.viewer, frame.viewer.x, frame.viewer.y, frame.viewer.z);
    gl_.Uniform2f(line_.limb, style.limb_begin, style.limb_end);
    gl_.Uniform1f(line_.bent, shown_.projection ? bent : 0);
    gl_.Uniform1i(line_.by_map, style.by_map ? 1 : 0);
    gl_.Uniform1i(line_.flat_cells, style.by_map && shown_.flat() ? 1 : 0);
    gl_.BindVertexArray(empty_array_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * set.count));
}

void MeshRenderer::set_depth_test(bool on) {
    if (on)
        gl_.Enable(GL_DEPTH_TEST);
    else
        gl_.Disable(GL_DEPTH_TEST);
    gl_.DepthFunc(GL_LEQUAL);
}

/// From here on lines are drawn into a layer, except where faces hide them.
void MeshRenderer::begin_layer(const Frame& frame, PixelRect area) {
    layer_.begin(area.width, area.height);
    set_depth_test(!frame.planar);
    bind_tables();
    if (!frame.planar) {
        gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        gl_.Enable(GL_POLYGON_OFFSET_FILL);
        gl_.PolygonOffset(2, 2); // away from the viewer, more so for steep faces, so that edges stay visible
        draw_fill(frame, {drawn_->array, 0, drawn_->parts.corners.size()});
        gl_.Disable(GL_POLYGON_OFFSET_FILL);
        gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    gl_.DepthMask(GL_FALSE);
}

void MeshRenderer::end_layer(const Frame& frame, PixelRect area, int bottom, Colour light_ink,
                             Colour dark_ink) {
    layer_.end(area.x, bottom, light_ink, dark_ink);
    bind_tables();
    set_depth_test(!frame.planar);
}

bool MeshRenderer::draw(const MeshScene& scene, const Camera& camera, PixelRect area, int framebuffer_height,
                        const Theme& theme, float scale, bool quickly, const std::function<bool()>& give_up) {
    if (area.width <= 0 || area.height <= 0) return true;
    GASPARD_CHECK(scene.tessellation != nullptr);
    upload(scene);
    drawn_ = &cells_for(quickly);
    const int bottom = framebuffer_height - area.y - area.height;
    clear(area, bottom, theme);
    bind_tables();

    const Size size = area.size();
    const double depth = view_depth(camera, scene.box);
    const Frame frame{clip_matrix(camera, size, centre_, depth),
                      {static_cast<float>(size.width / 2), static_cast<float>(size.height / 2),
                       static_cast<float>(depth / camera.scale)},
                      static_cast<float>(scene.blend),
                      scene.planar(),
                      logarithm_of(scene),
                      {single(Vec3{} - centre_), static_cast<float>(scene.ball)},
                      single(towards_viewer(camera))};
    const bool complete = draw_layers(frame, area, bottom, theme, scale,
                                      quickly && can_draft(scene.box.size() / camera.scale), [&] {
                                          if (!give_up) return false;
                                          gl_.Finish(); // what was asked for so far is drawn
                                          return give_up();
                                      });
    gl_.DepthMask(GL_TRUE);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Disable(GL_SCISSOR_TEST);
    return complete;
}

/// Of what is on the card, from the cells up. False if given up.
bool MeshRenderer::draw_layers(const Frame& frame, PixelRect area, int bottom, const Theme& theme,
                               float scale, bool draft, const std::function<bool()>& give_up) {
    const MeshScene& scene = shown_;
    const Colour nothing{0, 0, 0, 0};
    const bool plain = scene.colouring == nullptr;
    // On denser displays lines become finer relative to the image.
    const float fineness = std::max(1.0F, 0.7F * scale);
    LineStyle style;
    style.width = theme.line_width * fineness;
    const Fading& fading = plain ? plain_fading : coloured_fading;
    style.fade_begin = fading.begin * fineness;
    style.fade_end = fading.end * fineness;
    style.haze = fading.haze;
    style.pull = frame.planar ? 0 : pull_pixels / frame.clip_to_pixels.z;
    style.surface = plain ? theme.surface : nothing;
    style.flat_ink = nothing;
    style.limb_begin = limb_begin, style.limb_end = limb_end;
    set_depth_test(!frame.planar);
    if (draft) {
        draw_draft(frame, theme, style);
    } else {
        draw_cells(frame, style.surface);
        if (give_up()) return false;
        if (scene.cell_dimension > 1 && scene.lines) draw_edges(frame, area, bottom, theme, style);
    }
    if (give_up()) return false;
    if (scene.contours != nullptr) {
        begin_layer(frame, area);
        draw_contours(frame, style, scale);
        end_layer(frame, area, bottom, opaque(theme.line_on_dark), opaque(theme.line_on_light));
    }
    if (scene.overlay != nullptr) {
        begin_layer(frame, area);
        draw_overlay(frame, style, scale);
        end_layer(frame, area, bottom, theme.overlay, theme.overlay);
    }
    if (give_up()) return false;
    style.limb_begin = style.limb_end = 0;
    gl_.DepthMask(GL_FALSE);
    if (scene.cell_dimension == 1) draw_line_cells(frame, style, theme, scale);
    draw_tangled(frame, style, theme, scale);
    if (scene.arrows != nullptr) draw_arrows(frame, theme, scale);
    return true;
}

void MeshRenderer::draw_edges(const Frame& frame, PixelRect area, int bottom, const Theme& theme,
                              const LineStyle& style) {
    begin_layer(frame, area);
    draw_lines(frame, drawn_->edges, style);
    end_layer(frame, area, bottom, theme.line_on_dark, theme.line_on_light);
}

/// Curved cells of a ball.
bool MeshRenderer::is_round() const { return shown_.ball > 0 && shown_.tessellation->cuts > 1; }

/// Whether facets are parts of cells as they are, none lies over another, and a line does not reach beyond
/// those beside it. `across`: the diagonal of the mesh's box in pixels.
bool MeshRenderer::can_draft(double across) const {
    const double pixels = across * across / 4; // of the mesh, roughly
    return shown_.cell_dimension == 2 && !shown_.projection && drawn_->caps == 0 &&
           shown_.tangled == nullptr &&
           (drawn_->cuts == 1 ||
            3 * pixels > smallest_facet * static_cast<double>(drawn_->parts.corners.size()));
}

void MeshRenderer::draw_draft(const Frame& frame, const Theme& theme, const LineStyle& style) {
    const Colour none{0, 0, 0, 0};
    if (drawn_->cuts > 1) drawn_->sides.bind(gl_, mesh_unit::edges);
    draft_.draw(frame, drawn_->parts.facets.size(), drawn_->cuts,
                shown_.mesh->kind.shape == CellShape::quadrilateral,
                {style, shown_.lines ? theme.line_on_dark : none, shown_.lines ? theme.line_on_light : none,
                 shown_.flat(), is_round(), frame.planar ? 0 : dusk});
    if (!shown_.lines) return;
    LineStyle border = style; // its half outside
    border.flat_ink = theme.line_on_dark, border.ink_on_light = theme.line_on_light;
    border.haze = 0;
    draw_lines(frame, drawn_->border, border);
}

/// Cells that are lines: wide ones in the colours of their values, with their ends marked.
void MeshRenderer::draw_line_cells(const Frame& frame, LineStyle style, const Theme& theme, float scale) {
    style.width = line_cell_width * scale;
    style.flat_ink = theme.faint_text;
    style.by_map = shown_.colouring != nullptr;
    draw_lines(frame, drawn_->edges, style);
    if (!shown_.lines) return;
    style.by_map = false;
    style.width = rimmed_disc_width * scale;
    style.flat_ink = opaque(theme.background);
    draw_lines(frame, discs_, style);
    style.width = disc_width * scale;
    style.flat_ink = theme.text;
    draw_lines(frame, discs_, style);
}

/// Each line in one ink.
void MeshRenderer::draw_contours(const Frame& frame, LineStyle style, float scale) {
    bind_points(contours_computational_, contours_physical_);
    style.width = contour_width * std::max(1.0F, 0.7F * scale);
    style.haze = 0;
    style.surface = {0, 0, 0, 1};
    draw_lines(frame, contours_on_dark_, style);
    style.surface = {1, 1, 1, 1};
    draw_lines(frame, contours_on_light_, style);
    bind_points(computational_, physical_);
}

/// Its curves differ slightly from the faces of the scene; lines slightly below the faces stay visible.
void MeshRenderer::draw_overlay(Frame frame, LineStyle style, float scale) {
    bind_points(overlay_points_, overlay_points_);
    frame.blend = 1;
    style.width = overlay_width * std::max(1.0F, 0.7F * scale);
    style.surface = {1, 1, 1, 1}; // one ink, independent of the colours below
    style.haze = 0;
    style.limb_begin = limb_begin, style.limb_end = limb_end;
    if (!frame.planar) style.pull += overlay_pull;
    draw_lines(frame, overlay_edges_, style);
    bind_points(computational_, physical_);
}

void MeshRenderer::draw_tangled(const Frame& frame, LineStyle style, const Theme& theme, float scale) {
    if (outlines_.count == 0) return;
    const LineStyle thin = style;
    // If there are many, thin outlines keep them distinct.
    const float many = static_cast<float>(shown_.tangled->size()) / few_tangled;
    const float slim = std::max(0.3F, 1 / std::sqrt(std::max(1.0F, many)));
    style.fade_begin = -1, style.fade_end = 1e-6F; // opaque at any distance
    style.haze = 0;
    if (!frame.planar) style.pull += overlay_pull; // in front of the cells that it overlaps
    const auto outline = [&](float width, Colour ink) {
        style.width = width * scale * slim;
        style.flat_ink = ink;
        draw_lines(frame, outlines_, style);
    };
    outline(tangled_rim_width, opaque(theme.background));
    outline(tangled_ring_width, theme.text);
    draw_veil(frame, theme);
    outline(tangled_width, theme.tangled);
    if (tangled_count_ == 0 || !shown_.lines) return;
    style.fade_begin = thin.fade_end,
    style.fade_end = 3 * thin.fade_end; // only of cells that are large enough
    outline(thin.width / scale / slim, theme.line_on_light);
}

/// A colour over the tangled cells through which the mesh is still seen. In the plane, where they overlap, it
/// is laid only once: the first one to cover a pixel is nearer than what the depth buffer holds, the rest are
/// not.
void MeshRenderer::draw_veil(const Frame& frame, const Theme& theme) {
    if (tangled_count_ == 0) return;
    Colour veil = theme.tangled;
    veil.a = tangled_opacity;
    if (frame.planar) {
        gl_.Enable(GL_DEPTH_TEST);
        gl_.DepthFunc(GL_LESS);
        gl_.DepthMask(GL_TRUE);
    }
    bind_cells(cells_);
    draw_fill(frame, {tangled_array_, 0, tangled_count_, veil, dusk});
    if (!frame.planar) return;
    gl_.DepthMask(GL_FALSE);
    gl_.DepthFunc(GL_LEQUAL);
    gl_.Disable(GL_DEPTH_TEST);
}

void MeshRenderer::draw_arrows(const Frame& frame, const Theme& theme, float scale) {
    gl_.UseProgram(arrow_program_.name());
    arrows_.bind(gl_, mesh_unit::segments);
    gl_.UniformMatrix4fv(arrow_.clip, 1, GL_FALSE, glm::value_ptr(frame.clip));
    gl_.Uniform2f(arrow_.half_viewport, frame.clip_to_pixels.x, frame.clip_to_pixels.y);
    gl_.Uniform1f(arrow_.head_width, arrow_head_width * scale);
    gl_.Uniform1f(arrow_.shaft_width, arrow_shaft_width * scale);
    gl_.Uniform1f(arrow_.rim_width, arrow_rim_width * scale);
    gl_.Uniform1f(arrow_.pull, frame.planar ? 0 : arrow_pull);
    // Colour maps are mostly dark, independent of the theme, so a light arrow has the better contrast.
    const auto sum = [](Colour c) { return c.r + c.g + c.b; };
    const bool swapped = shown_.colouring != nullptr && sum(theme.text) < sum(theme.background);
    const Colour ground = opaque(theme.background);
    set_colour(gl_, arrow_.ink, swapped ? ground : theme.text);
    set_colour(gl_, arrow_.rim, swapped ? theme.text : ground);
    gl_.BindVertexArray(empty_array_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * shown_.arrows->size()));
}

} // namespace gaspard
