#include "core/io/section_files.hpp"

#include "core/io/atomic_file.hpp"
#include "core/io/svg.hpp"
#include "core/tessellate/line_section.hpp"

namespace gaspard {

bool has_section_files(const Mesh& mesh, const Values& view) {
    return !view.text("section").empty() && view.text("color") != "none" && has_section_line(mesh);
}

void write_section_files(const std::filesystem::path& folder, const Snapshot& snapshot, const Values& view) {
    const auto line = parse_section_line(view.text("section"));
    const auto colouring = make_colouring(snapshot, colour_choice(view));
    if (!line || !colouring) return;
    const ValuesOnLine values = values_on_line(snapshot, *colouring, *line);
    write_atomically(folder / section_file_names[0], section_line_csv(values, *colouring, *line));
    Plot plot = section_line_plot(values, *colouring);
    plot.y.logarithmic = colouring->range.logarithmic;
    write_svg(folder / section_file_names[1], plot);
}

} // namespace gaspard
