#include "gui/render/mesh_draft.hpp"

#include <glm/gtc/type_ptr.hpp>

namespace gaspard {

MeshDraft::MeshDraft(const Gl& gl) : gl_(gl), program_(make_program(gl, "mesh_draft")), empty_array_(gl) {
    const auto place = [&](const char* name) { return uniform(gl, program_, name); };
    uniforms_ = {place("clip"),       place("blend"),       place("clip_to_pixels"), place("logarithm"),
                 place("ball"),       place("viewer"),      place("quadrilaterals"), place("cuts"),
                 place("flat_cells"), place("round_cells"), place("surface"),        place("half_width"),
                 place("fade"),       place("haze"),        place("limb"),           place("dusk"),
                 place("light_ink"),  place("dark_ink")};
    gl.UseProgram(program_.name());
    gl.Uniform1i(place("computational"), mesh_unit::computational);
    gl.Uniform1i(place("physical"), mesh_unit::physical);
    gl.Uniform1i(place("colours"), mesh_unit::colours);
    gl.Uniform1i(place("shown_cells"), mesh_unit::cells);
    gl.Uniform1i(place("cell_values"), mesh_unit::cell_values);
    gl.Uniform1i(place("facets"), mesh_unit::facets);
    gl.Uniform1i(place("edges"), mesh_unit::edges);
}

void MeshDraft::draw(const MeshFrame& frame, std::size_t facets, int cuts, bool quadrilaterals,
                     const DraftLook& look) {
    const auto set = [&](GLint where, Colour c) { gl_.Uniform4f(where, c.r, c.g, c.b, c.a); };
    const auto set3 = [&](GLint where, const glm::vec3& v) { gl_.Uniform3f(where, v.x, v.y, v.z); };
    gl_.UseProgram(program_.name());
    gl_.UniformMatrix4fv(uniforms_.clip, 1, GL_FALSE, glm::value_ptr(frame.clip));
    gl_.Uniform1f(uniforms_.blend, frame.blend);
    set3(uniforms_.clip_to_pixels, frame.clip_to_pixels);
    gl_.Uniform1f(uniforms_.logarithm, frame.logarithm);
    gl_.Uniform4f(uniforms_.ball, frame.ball.x, frame.ball.y, frame.ball.z, frame.ball.w);
    set3(uniforms_.viewer, frame.viewer);
    gl_.Uniform1i(uniforms_.quadrilaterals, quadrilaterals ? 1 : 0);
    gl_.Uniform1i(uniforms_.cuts, cuts);
    gl_.Uniform1i(uniforms_.round_cells, look.round_cells ? 1 : 0);
    gl_.Uniform1i(uniforms_.flat_cells, look.flat_cells ? 1 : 0);
    set(uniforms_.surface, look.edges.surface);
    gl_.Uniform1f(uniforms_.half_width, look.edges.width / 2);
    gl_.Uniform2f(uniforms_.fade, look.edges.fade_begin, look.edges.fade_end);
    gl_.Uniform1f(uniforms_.haze, look.edges.haze);
    gl_.Uniform2f(uniforms_.limb, look.edges.limb_begin, look.edges.limb_end);
    gl_.Uniform1f(uniforms_.dusk, look.dusk);
    set(uniforms_.light_ink, look.light_ink);
    set(uniforms_.dark_ink, look.dark_ink);
    gl_.BindVertexArray(empty_array_.name());
    gl_.DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(facets * (quadrilaterals ? 6 : 3)));
}

} // namespace gaspard
