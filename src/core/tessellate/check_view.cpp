#include "core/tessellate/check_view.hpp"

#include "core/base/error.hpp"
#include "core/base/short_number.hpp"
#include "core/tessellate/background.hpp"
#include "core/tessellate/camera.hpp"
#include "core/tessellate/cell_geometry.hpp"
#include "core/tessellate/inside_choice.hpp"
#include "core/tessellate/line_section.hpp"
#include "core/tessellate/pick.hpp"

namespace gaspard {

void check_view(const Values& view, const Mesh* mesh) {
    for (const char* key : {"camera", "projection_camera", "elevation_camera"}) try {
            if (!view.text(key).empty()) parse_camera(view.text(key), {1, 1});
        } catch (const InputError& error) {
            throw InputError("view." + std::string(key) + ": " + error.what());
        }
    parse_background(view.text("background"));
    parse_section_line(view.text("section"));
    const auto pick = parse_pick(view.text("pick"));
    if (pick && mesh != nullptr && !has(*mesh, *pick))
        throw InputError("view.pick = '" + view.text("pick") + "': the mesh has " +
                         (pick->kind == Pick::Kind::cell ? std::to_string(mesh->cell_count()) + " cells"
                                                         : std::to_string(mesh->node_count()) + " nodes") +
                         ", counted from 0");
    const InsideChoice inside = inside_choice(view);
    if (mesh != nullptr) check_layers(inside, *mesh);
    const std::string& layout = view.text("layout");
    if (mesh != nullptr && layout == "projection" && !(radius_of_ball(*mesh) > 0))
        throw InputError(
            "view.layout = projection is only for meshes on a sphere; use single or side-by-side");
    if (mesh != nullptr && layout == "front-and-rear" && mesh->space_dimension < 3)
        throw InputError(
            "view.layout = front-and-rear is only for meshes in space; use single or side-by-side");
    if (view.text("range") == "fixed" && !(view.real("low") < view.real("high")))
        throw InputError("view.low = " + exact_number(view.real("low")) +
                         " must be below view.high = " + exact_number(view.real("high")));
}

} // namespace gaspard
