#include "core/base/check.hpp"
#include "core/io/atomic_file.hpp"
#include "core/io/svg.hpp"
#include "core/io/svg_axes.hpp"
#include "core/io/svg_document.hpp"
#include "core/io/svg_legend.hpp"
#include "core/io/svg_scene.hpp"
#include "core/io/svg_section.hpp"
#include "core/tessellate/blend.hpp"
#include "core/tessellate/colouring.hpp"
#include "core/tessellate/plane_axes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace gaspard {

namespace {

constexpr const char *dark_ink = svg_dark_ink, *light_ink = svg_light_ink, *tangled_colour = "#e600b8";
constexpr double margin = 6, legend_gap = 10, panel_gap = 10, highest_bar = 170,
                 note_height = 1.5 * svg_font_size; // points
constexpr double contour_width = 0.7;
constexpr double veil_opacity = 0.45, few_tangled = 20; // as in MeshRenderer
constexpr double skin_light = 0.78, skin_grey = 0.55;   // as in mesh_fill.frag

/// Everything the drawing functions share.
struct Drawing {
    const SvgScene& scene;
    const SvgView& view;
    const SvgClasses& classes;
    std::string name{}; ///< of the mesh, before the ids of its groups
    bool lines = true;
    int decimals = 2;
    std::vector<bool> shown{}; ///< per face or line

    std::string group(const std::string& id) const { return "<g id=\"" + name + id + "\""; }

    PagePoint node(std::int32_t number) const { return view.page(scene.x[static_cast<std::size_t>(number)]); }
    void go(SvgPath& path, const Side& side) const {
        const PagePoint to = node(side.to);
        if (side.between == 0) return path.line(to);
        if (side.between > 1) return go_in_pieces(path, side);
        parabola(path, node(side.from), node(side.through[0]), to);
    }
    /// The parabola through a point in the middle.
    static void parabola(SvgPath& path, PagePoint from, PagePoint middle, PagePoint to) {
        path.curve({2 * middle.x - (from.x + to.x) / 2, 2 * middle.y - (from.y + to.y) / 2}, to);
    }
    /// Of a higher order, parabolas that follow the curve.
    void go_in_pieces(SvgPath& path, const Side& side) const {
        const CellKind kind{CellShape::line, side.between + 1};
        const auto count = static_cast<std::size_t>(nodes_per_cell(kind));
        std::vector<double> values(count);
        std::vector<Vec3> gradients(count);
        const auto at = [&](double t) {
            shape_functions(kind, {t, 0, 0}, values, gradients);
            PagePoint sum;
            for (std::size_t k = 0; k < count; ++k) {
                const PagePoint p = node(k == 0 ? side.from : k == 1 ? side.to : side.through[k - 2]);
                sum = {sum.x + values[k] * p.x, sum.y + values[k] * p.y};
            }
            return sum;
        };
        PagePoint from = node(side.from);
        for (int piece = 0; piece < side.between; ++piece) {
            const PagePoint to = piece + 1 == side.between ? node(side.to) : at((piece + 1.0) / side.between);
            parabola(path, from, at((piece + 0.5) / side.between), to);
            from = to;
        }
    }
    void add(SvgPath& path, const std::vector<Side>& line, bool closed) const {
        path.move(node(line.front().from));
        for (const Side& side : line) go(path, side);
        if (closed) path.close();
    }
    double length(const Side& side) const {
        const PagePoint a = node(side.from), b = node(side.to);
        return std::hypot(a.x - b.x, a.y - b.y);
    }
    /// About how far one side of a face is from the opposite one, where that is nearest.
    double narrowness(std::size_t face) const {
        double twice_area = 0, longest = 0;
        for (const Side& side : sides_of_face(scene.faces, face)) {
            const PagePoint a = node(side.from), b = node(side.to);
            twice_area += a.x * b.y - b.x * a.y;
            longest = std::max(longest, length(side));
        }
        return longest > 0 ? std::abs(twice_area) / 2 / longest : 0;
    }
};

// Where lines lie close together they are thinner, so that the colours between them are seen.
constexpr std::array line_widths = {0.4, 0.28, 0.2, 0.14, 0.1, 0.07, 0.05}; // points

std::size_t width_class(double narrowness) {
    constexpr double share = 0.13; // of the space between, at most
    std::size_t k = 0;
    while (k + 1 < line_widths.size() && line_widths[k] > share * narrowness) ++k;
    return k;
}

/// Decimals of a point that tell the nodes of all but a hundredth of the faces apart.
int decimals_of(const Drawing& drawing) {
    std::vector<double> sizes;
    const SvgScene& scene = drawing.scene;
    for (std::size_t i = 0; i < scene.size(); ++i)
        if (drawing.shown[i])
            sizes.push_back(scene.lines.empty() ? drawing.narrowness(i) : drawing.length(scene.lines[i]));
    if (sizes.empty()) return 2;
    const auto small = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 100);
    std::nth_element(sizes.begin(), small, sizes.end());
    return *small < 0.15 ? 3 : 2;
}

std::string contour_look(bool light) {
    return " fill=\"none\" stroke=\"" + std::string(light ? light_ink : dark_ink) + "\" stroke-width=\"" +
           svg_number(contour_width) + "\" stroke-linejoin=\"round\" stroke-linecap=\"round\"";
}

/// One path per class around all of its cells, and one for each tangled cell, which would cancel with others.
std::string flat_fill(const Drawing& drawing) {
    const SvgScene& scene = drawing.scene;
    std::vector<std::vector<std::uint32_t>> members(drawing.classes.count());
    for (std::size_t f = 0; f < scene.faces.size(); ++f)
        if (drawing.shown[f] && !scene.tangled[f])
            members[drawing.classes.of(f)].push_back(static_cast<std::uint32_t>(f));
    std::string text = drawing.group("cells") + ">\n";
    for (std::size_t k = 0; k < members.size(); ++k) {
        SvgPath path(drawing.decimals);
        for (const auto& loop : outline(scene.faces, members[k])) drawing.add(path, loop, true);
        text += path_element(path, " fill=\"" + drawing.classes.colour(k) + '"');
    }
    for (std::size_t f = 0; f < scene.faces.size(); ++f) {
        if (!drawing.shown[f] || !scene.tangled[f]) continue;
        SvgPath path(drawing.decimals);
        drawing.add(path, sides_of_face(scene.faces, f), true);
        text += path_element(path, " fill=\"" + drawing.classes.colour(drawing.classes.of(f)) + '"');
    }
    return text + "</g>\n";
}

std::string line_group(const Drawing& drawing, const std::vector<Side>& edges, const std::string& ink,
                       double width) {
    if (edges.empty()) return "";
    std::string text = "<g fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"" + svg_number(width, 3) +
                       "\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    for (const auto& line : chain(edges, drawing.scene.xi)) {
        SvgPath path(drawing.decimals);
        drawing.add(path, line, false);
        text += path_element(path);
    }
    return text + "</g>\n";
}

std::string flat_edges(const Drawing& drawing) {
    const SvgClasses& classes = drawing.classes;
    std::array<std::array<std::vector<Side>, line_widths.size()>, 2> groups; // light and dark ink
    for (const DrawnEdge& edge : edges_of(drawing.scene.faces)) {
        const auto [a, b] = edge.faces;
        if (!drawing.shown[a] && !drawing.shown[b]) continue;
        const std::size_t ink = classes.wants_light_ink(classes.of(a), classes.of(b)) ? 0 : 1;
        const double narrow = std::min(drawing.narrowness(a), drawing.narrowness(b));
        groups[ink][width_class(narrow)].push_back(edge.side);
    }
    std::string text = drawing.group("edges") + ">\n";
    for (std::size_t ink = 0; ink < 2; ++ink)
        for (std::size_t k = 0; k < line_widths.size(); ++k)
            text += line_group(drawing, groups[ink][k], ink == 0 ? light_ink : dark_ink, line_widths[k]);
    return text + "</g>\n";
}

/// As long lines.
std::string flat_contours(const Drawing& drawing) {
    const SvgContours& contours = drawing.scene.contours;
    std::array<std::vector<Side>, 2> groups; // light and dark ink
    for (std::size_t i = 0; i < contours.segments.size(); ++i)
        if (drawing.shown[contours.cells[i]])
            groups[drawing.classes.level_wants_light_ink(contours.levels[i]) ? 0 : 1].push_back(
                contours.segments[i]);
    std::string text;
    for (std::size_t ink = 0; ink < 2; ++ink) {
        SvgPath path(drawing.decimals);
        for (const auto& line : chain(groups[ink], contours.x)) {
            path.move(drawing.view.page(contours.x[static_cast<std::size_t>(line.front().from)]));
            for (const Side& side : line)
                path.line(drawing.view.page(contours.x[static_cast<std::size_t>(side.to)]));
        }
        text += path_element(path, contour_look(ink == 0));
    }
    return text.empty() ? text : drawing.group("contours") + ">\n" + text + "</g>\n";
}

/// Those of one face of a surface, whose faces are its cells.
std::string face_contours(const Drawing& drawing, std::uint32_t face, bool light) {
    const SvgContours& contours = drawing.scene.contours;
    const auto [begin, end] = std::equal_range(contours.cells.begin(), contours.cells.end(), face);
    SvgPath path(drawing.decimals);
    for (auto i = begin - contours.cells.begin(); i < end - contours.cells.begin(); ++i) {
        const Side& side = contours.segments[static_cast<std::size_t>(i)];
        path.move(drawing.view.page(contours.x[static_cast<std::size_t>(side.from)]));
        path.line(drawing.view.page(contours.x[static_cast<std::size_t>(side.to)]));
    }
    return path_element(path, contour_look(light));
}

/// As the window shows it: outlines on rings that are seen on every colour, and a veil through which the mesh
/// is seen, once where cells overlap.
std::string flat_tangled(const Drawing& drawing) {
    SvgPath outlines(drawing.decimals);
    std::size_t count = 0;
    std::string veil; // cell by cell: in one path, overlapping cells of opposite orientation would cancel
    for (std::size_t f = 0; f < drawing.scene.faces.size(); ++f) {
        if (!drawing.shown[f] || !drawing.scene.tangled[f]) continue;
        SvgPath path(drawing.decimals);
        drawing.add(path, sides_of_face(drawing.scene.faces, f), true);
        veil += path_element(path);
        ++count;
        drawing.add(outlines, sides_of_face(drawing.scene.faces, f), true);
    }
    if (veil.empty()) return "";
    // If there are many, thin outlines keep them distinct.
    const double slim = std::max(0.3, 1 / std::sqrt(std::max(1.0, static_cast<double>(count) / few_tangled)));
    const auto stroke = [&](const std::string& ink, double width) {
        return path_element(outlines, " fill=\"none\" stroke=\"" + ink + "\" stroke-width=\"" +
                                          svg_number(slim * width) + '"');
    };
    const std::string colour = tangled_colour;
    return drawing.group("tangled") + " stroke-linejoin=\"round\">\n" + stroke("#fff", 1.9) +
           stroke(dark_ink, 1.4) + drawing.group("veil") + " fill=\"" + colour + "\" opacity=\"" +
           svg_number(veil_opacity) + "\">\n" + veil + "</g>\n" + stroke(colour, 0.8) + "</g>\n";
}

/// Over a face of a tangled cell; nothing over others.
std::string face_veil(const Drawing& drawing, std::uint32_t face, const SvgPath& path, double outline) {
    if (!drawing.scene.tangled[face]) return "";
    const std::string colour = tangled_colour;
    return path_element(
        path, " class=\"tangled\" fill=\"" + colour + "\" fill-opacity=\"" + svg_number(veil_opacity) +
                  "\" stroke=\"" +
                  (outline > 0 ? colour + "\" stroke-width=\"" + svg_number(outline) : std::string("none")) +
                  '"');
}

/// Face by face, the nearer over the farther; neighbours of one class in one group.
std::string spatial_faces(const Drawing& drawing) {
    const SvgScene& scene = drawing.scene;
    std::string text = drawing.group("cells") + " stroke-linejoin=\"round\">\n";
    std::string group; // the one that is open
    for (const auto f : painters_order(scene, drawing.view)) {
        if (!drawing.shown[f]) continue;
        const std::size_t k = drawing.classes.of(f);
        const bool light = drawing.classes.wants_light_ink(k, k);
        const std::string fill = drawing.classes.colour(k);
        const std::string ink = !drawing.lines ? fill : light ? light_ink : dark_ink; // or gaps shine through
        const std::string look = "<g fill=\"" + fill + "\" stroke=\"" + ink + "\" stroke-width=\"" +
                                 svg_number(line_widths[width_class(drawing.narrowness(f))]) + "\">\n";
        if (group != look) text += (group.empty() ? "" : "</g>\n") + look;
        group = look;
        SvgPath path(drawing.decimals);
        drawing.add(path, sides_of_face(scene.faces, f), true);
        text += path_element(path) + face_contours(drawing, f, light) + face_veil(drawing, f, path, 0.8);
    }
    return text + (group.empty() ? "" : "</g>\n") + "</g>\n";
}

/// Paler and darker, as the window shows the skin of a solid that is cut (shaders/mesh_fill.frag).
std::array<unsigned char, 3> pale(std::array<unsigned char, 3> colour) {
    const double grey = 0.299 * colour[0] + 0.587 * colour[1] + 0.114 * colour[2];
    for (unsigned char& part : colour)
        part =
            static_cast<unsigned char>(std::lround(skin_light * ((1 - skin_grey) * part + skin_grey * grey)));
    return colour;
}

/// How far a side is from the next one.
double spacing(const Drawing& drawing, const SectionSide& side) {
    const PagePoint a = drawing.node(side.from), b = drawing.node(side.to);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const auto away = [&](std::int32_t far) {
        const PagePoint p = drawing.node(far);
        return std::abs((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / std::max(length, 1e-9);
    };
    return std::min(away(side.first), away(side.second));
}

/// The colour of a triangle of a section, and whether lines on it are light.
std::pair<std::array<unsigned char, 3>, bool> section_colour(const Drawing& drawing, std::uint32_t face) {
    const SvgScene& scene = drawing.scene;
    const auto own = drawing.classes.parts(drawing.classes.of(face));
    const bool skin = scene.caps > 0 && face < scene.size() - scene.caps;
    const auto colour = skin ? pale(own) : own;
    return {colour, svg_luminance(colour) < 0.13};
}

/// The lines of a section, per triangle of `order` those to be drawn after it: once no triangle that touches
/// them is left.
std::vector<std::string> section_lines(const Drawing& drawing, const std::vector<std::uint32_t>& order) {
    const SvgScene& scene = drawing.scene;
    std::vector<std::size_t> last(scene.x.size(), 0); // triangle of a point
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const std::int32_t point : scene.faces[order[i]]) last[static_cast<std::size_t>(point)] = i;
    std::vector<std::string> lines(order.size());
    std::vector<bool> done(scene.section_sides.size(), false);
    for (auto f = order.rbegin(); f != order.rend(); ++f) // the ink is for the nearest triangle
        for (const Side& side : sides_of_face(scene.faces, *f)) {
            const SectionSide* line = find_section_side(scene, side.from, side.to);
            if (line == nullptr) continue;
            const auto number = static_cast<std::size_t>(line - scene.section_sides.data());
            if (done[number]) continue;
            done[number] = true;
            SvgPath stroke(drawing.decimals);
            drawing.add(stroke, {side}, false);
            const double width = line_widths[width_class(spacing(drawing, *line))];
            const char* ink = section_colour(drawing, *f).second ? light_ink : dark_ink;
            lines[std::max(last[static_cast<std::size_t>(side.from)],
                           last[static_cast<std::size_t>(side.to)])] +=
                path_element(stroke, " fill=\"none\" stroke=\"" + std::string(ink) + "\" stroke-width=\"" +
                                         svg_number(width) + '"');
        }
    return lines;
}

/// Triangle by triangle, the nearer over the farther, with lines between.
std::string section_faces(const Drawing& drawing) {
    const SvgScene& scene = drawing.scene;
    std::string text = drawing.group("cells") + " stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    std::string group; // the one that is open
    std::vector<std::uint32_t> order = painters_order(scene, drawing.view);
    std::erase_if(order, [&](std::uint32_t face) { return !drawing.shown[face]; });
    const std::vector<std::string> lines =
        drawing.lines ? section_lines(drawing, order) : std::vector<std::string>(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t f = order[i];
        const auto [colour, light] = section_colour(drawing, f);
        const std::string fill = svg_colour(colour);
        const std::string look = "<g fill=\"" + fill + "\" stroke=\"" + fill + "\" stroke-width=\".2\">\n";
        if (group != look) text += (group.empty() ? "" : "</g>\n") + look;
        group = look;
        SvgPath path(drawing.decimals);
        drawing.add(path, sides_of_face(scene.faces, f), true);
        text +=
            path_element(path) + face_contours(drawing, f, light) + lines[i] + face_veil(drawing, f, path, 0);
    }
    return text + (group.empty() ? "" : "</g>\n") + "</g>\n";
}

/// A curve's cells in their colours, with dots between them.
std::string coloured_lines(const Drawing& drawing) {
    const SvgScene& scene = drawing.scene;
    std::string text;
    for (std::size_t k = 0; k < drawing.classes.count(); ++k) {
        std::vector<Side> members;
        for (std::size_t i = 0; i < scene.lines.size(); ++i)
            if (drawing.shown[i] && !scene.tangled[i] && drawing.classes.of(i) == k)
                members.push_back(scene.lines[i]);
        const std::string ink = scene.values.empty() ? dark_ink : drawing.classes.colour(k);
        text += line_group(drawing, members, ink, 2);
    }
    std::vector<Side> tangled;
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        if (drawing.shown[i] && scene.tangled[i]) tangled.push_back(scene.lines[i]);
    text += line_group(drawing, tangled, tangled_colour, 2) + drawing.group("nodes") + " fill=\"" + dark_ink +
            "\">\n";
    for (std::size_t i = 0; i < scene.lines.size(); ++i)
        for (const std::int32_t end : {scene.lines[i].from, scene.lines[i].to}) {
            if (!drawing.shown[i]) continue;
            const PagePoint p = drawing.node(end);
            text += "<circle cx=\"" + svg_number(p.x) + "\" cy=\"" + svg_number(p.y) + "\" r=\".9\"/>\n";
        }
    return text + "</g>\n";
}

/// The sentence that says what is wrong, with its colour; nothing if all is well.
std::string tangled_note(const SvgScene& scene, PagePoint at) {
    std::vector<std::uint32_t> cells; // a solid's cell may show several faces
    for (std::size_t f = 0; f < scene.size(); ++f)
        if (scene.tangled[f])
            cells.push_back(scene.lines.empty() ? scene.faces.cells[f] : static_cast<std::uint32_t>(f));
    std::sort(cells.begin(), cells.end());
    const auto count = std::unique(cells.begin(), cells.end()) - cells.begin();
    if (count == 0) return "";
    return svg_block(at.x, at.y - 0.75 * svg_font_size, svg_font_size, 0.9 * svg_font_size,
                     "fill=\"" + std::string(tangled_colour) + '"') +
           svg_text({at.x + 1.5 * svg_font_size, at.y}, Anchor::start,
                    std::to_string(count) + (count == 1 ? " tangled cell" : " tangled cells"),
                    "fill=\"#222\"");
}

std::string mesh_content(const Drawing& drawing) {
    if (!drawing.scene.lines.empty()) return coloured_lines(drawing);
    if (drawing.scene.section) return section_faces(drawing);
    if (drawing.scene.spatial) return spatial_faces(drawing);
    return flat_fill(drawing) + (drawing.lines ? flat_edges(drawing) : "") + flat_contours(drawing) +
           flat_tangled(drawing);
}

/// Which faces or lines of the scene the view shows.
std::vector<bool> shown_parts(const SvgScene& scene, const SvgView& view) {
    std::vector<bool> shown(scene.size(), true);
    if (!view.cropped) return shown;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (scene.lines.empty()) {
            shown[i] = view.shows(scene.x, scene.faces[i]);
            continue;
        }
        const Side& line = scene.lines[i];
        std::vector<std::int32_t> nodes = {line.from, line.to};
        nodes.insert(nodes.end(), line.inside().begin(), line.inside().end());
        shown[i] = view.shows(scene.x, nodes);
    }
    return shown;
}

/// Clips what lies outside the view.
std::string cropped(const SvgView& view, const std::string& name, const std::string& content) {
    if (!view.cropped) return content;
    return "<clipPath id=\"" + name + "view\">" +
           svg_block(view.corner.x, view.corner.y, view.width, view.height, "fill=\"none\"") +
           "</clipPath>\n<g clip-path=\"url(#" + name + "view)\">\n" + content + "</g>\n";
}

Snapshot moved(const Snapshot& snapshot, double t) {
    if (t == 1) return snapshot;
    Snapshot between = snapshot;
    const Points& xi = snapshot.mesh->nodes;
    for (auto of : {&Points::x, &Points::y, &Points::z})
        for (std::size_t i = 0; i < (xi.*of).size(); ++i)
            (between.x.*of)[i] = blended((xi.*of)[i], (snapshot.x.*of)[i], t);
    return between;
}

/// One view of all meshes, so that they are of one scale.
SvgView common_view(const std::vector<SvgScene>& scenes, const MeshSvgOptions& options, PagePoint corner,
                    double width) {
    if (scenes.size() == 1) return svg_view(scenes.front(), options, corner, width);
    SvgScene all = scenes.back();
    for (const SvgScene& scene : scenes)
        for (auto of : {&Points::x, &Points::y, &Points::z})
            (all.x.*of).insert((all.x.*of).end(), (scene.x.*of).begin(), (scene.x.*of).end());
    return svg_view(all, options, corner, width);
}

std::string panel_title(const std::string& title, PagePoint above) {
    return title.empty() ? "" : svg_text(above, Anchor::middle, title, "fill=\"#222\"");
}

std::string panel_content(const SvgScene& scene, const SvgView& view, const SvgClasses& classes,
                          const std::string& name, bool lines) {
    Drawing drawing{scene, view, classes, name, lines};
    drawing.shown = shown_parts(scene, view);
    drawing.decimals = decimals_of(drawing);
    return cropped(view, name, mesh_content(drawing));
}

/// Where the parts of a drawing are, in points.
struct SvgPlaces {
    double page_width = 0, page_height = 0; ///< height 0: as high as the content
    double part = 0;                        ///< width of a mesh
    double left = margin, top = margin;     ///< of the first mesh
    double height = 0;                      ///< of meshes and legend
    double legend = 0;                      ///< its left edge
    SvgAxesRoom axes{};                     ///< of each mesh; 0: none
    SvgView view{};                         ///< of the first mesh
    std::vector<std::string> caption{};     ///< lines
};

SvgPlaces places_of(const std::vector<SvgPanel>& panels, const std::vector<SvgScene>& scenes,
                    const std::optional<Colouring>& legend, const MeshSvgOptions& options) {
    SvgPlaces at;
    const double points = points_per_mm / options.text_size, gaps = panel_gap * (double(panels.size()) - 1);
    const double width = at.page_width = options.width_mm * points;
    if (options.axes) at.axes = svg_room_for_axes(scenes.back());
    at.page_height = options.height_mm * points;
    at.caption = svg_lines(options.caption, width - 2 * margin);
    const double beside = legend ? legend_gap + svg_legend_width(*legend, highest_bar) : 0;
    const auto count = static_cast<double>(panels.size());
    at.part = (width - 2 * margin - beside - gaps) / count - at.axes.left;
    at.left += at.axes.left;
    if (!panels.front().title.empty()) at.top += 2 * svg_font_size;
    at.view = common_view(scenes, options, {at.left, at.top}, at.part);
    const bool tangled = options.note && !tangled_note(scenes.back(), {}).empty();
    const double room = at.page_height - at.top - margin - at.axes.below -
                        note_height * (static_cast<double>(at.caption.size()) + (tangled ? 1 : 0));
    if (at.page_height > 0 && at.view.height > room && room > 0) { // smaller, in the middle
        const double part = at.part * room / at.view.height;
        at.left += count * (at.part - part) / 2;
        at.part = part;
        at.view = common_view(scenes, options, {at.left, at.top}, at.part);
    }
    at.height = std::max(at.view.height, legend ? 90.0 : 0.0);
    at.legend = at.left + count * at.part + (count - 1) * (panel_gap + at.axes.left) + legend_gap;
    return at;
}

std::string moved_down(const std::string& content, double by) {
    return "<g transform=\"translate(0 " + svg_number(by) + ")\">\n" + content + "</g>\n";
}

} // namespace

std::string svg_of_meshes(const Snapshot& snapshot, const std::vector<SvgPanel>& panels,
                          const MeshSvgOptions& options) {
    GASPARD_CHECK(!panels.empty());
    const bool section = cell_dimension(snapshot.mesh->kind) == 3 && options.inside.looks_inside();
    std::vector<SvgScene> scenes;
    for (const SvgPanel& panel : panels)
        scenes.push_back(section
                             ? svg_section(snapshot, panel.blend, panel.colouring, options.inside)
                             : svg_scene(moved(snapshot, panel.blend), panel.colouring, options.elevation));
    const std::optional<Colouring> legend = options.legend ? panels.back().colouring : std::nullopt;
    MeshSvgOptions drawn = options;
    drawn.axes = options.axes && has_plane_axes(*snapshot.mesh) && !scenes.back().spatial;
    const SvgPlaces at = places_of(panels, scenes, legend, drawn);
    const double step = at.part + panel_gap + at.axes.left;
    SvgView view = at.view;
    std::string content;
    for (std::size_t k = 0; k < panels.size(); ++k) {
        const std::string name = k + 1 == panels.size() ? "" : panels[k].title + "-";
        content += panel_title(panels[k].title, {view.corner.x + at.part / 2, at.top - svg_font_size});
        content += panel_content(scenes[k], view, SvgClasses(scenes[k], panels[k].colouring, options.classes),
                                 name, options.lines);
        if (drawn.axes) content += svg_axes(scenes[k], view, name, panels[k].blend == 0);
        view.corner.x += step, view.origin.x += step;
    }
    if (legend) {
        const auto words = static_cast<double>(svg_legend_words(*legend).size());
        content +=
            svg_colour_bar(SvgClasses(scenes.back(), legend, options.classes), *legend, {at.legend, at.top},
                           std::min(at.height - 1.5 * svg_font_size * words, highest_bar));
    }
    double height = at.top + std::max(at.height, at.view.height + at.axes.below) + margin;
    const std::string note =
        options.note ? tangled_note(scenes.back(), {at.left, height + 0.75 * svg_font_size}) : "";
    if (!note.empty()) content += note, height += note_height;
    for (const std::string& line : at.caption) {
        content += svg_text({at.left, height + 0.75 * svg_font_size}, Anchor::start, line, "fill=\"#444\"");
        height += note_height;
    }
    return svg_document(at.page_width, at.page_height > 0 ? at.page_height : height,
                        "Mesh after " + std::to_string(snapshot.report.iteration) + " iterations",
                        at.page_height > 0 ? moved_down(content, (at.page_height - height) / 2) : content,
                        svg_background(options.background), options.text_size);
}

std::string svg_of_mesh(const Snapshot& snapshot, const std::optional<Colouring>& colouring,
                        const MeshSvgOptions& options) {
    return svg_of_meshes(snapshot, {{.colouring = colouring}}, options);
}

void write_svg(const std::filesystem::path& file, const Snapshot& snapshot,
               const std::vector<SvgPanel>& panels, const MeshSvgOptions& options) {
    write_atomically(file, svg_of_meshes(snapshot, panels, options));
}

} // namespace gaspard
