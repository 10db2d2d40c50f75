#include "gui/gl/imgui_renderer.hpp"

#include "gui/gl/draw_changes.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>

namespace gaspard {

namespace {

const void* offset(std::size_t bytes) {
    return reinterpret_cast<const void*>(static_cast<std::uintptr_t>(bytes)); // what OpenGL calls a pointer
}

} // namespace

FontPixels pixels_of(ImFontAtlas& atlas) {
    unsigned char* pixels = nullptr;
    FontPixels font;
    atlas.GetTexDataAsRGBA32(&pixels, &font.width, &font.height);
    font.rgba = pixels;
    return font;
}

ImGuiRenderer::ImGuiRenderer(const Gl& gl, const FontPixels& font)
    : gl_(gl), program_(make_program(gl, "imgui")), clip_(uniform(gl, program_, "clip")), array_(gl),
      vertices_(gl), indices_(gl), font_(gl) {
    gl.UseProgram(program_.name());
    gl.Uniform1i(uniform(gl, program_, "image"), 0);
    gl.BindVertexArray(array_.name());
    gl.BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
    const auto attribute = [&](GLuint index, GLint count, GLenum type, GLboolean normalised, std::size_t at) {
        gl.EnableVertexAttribArray(index);
        gl.VertexAttribPointer(index, count, type, normalised, sizeof(ImDrawVert), offset(at));
    };
    attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
    attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
    attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
    upload(font_, font.width, font.height, font.rgba);
}

ImGuiRenderer::ImGuiRenderer(const Gl& gl) : ImGuiRenderer(gl, pixels_of(*ImGui::GetIO().Fonts)) {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendRendererName = "gaspard";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.Fonts->SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(font_.name())));
}

void ImGuiRenderer::update_font() {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    const FontPixels font = pixels_of(atlas);
    upload(font_, font.width, font.height, font.rgba);
    atlas.SetTexID(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(font_.name())));
}

void ImGuiRenderer::upload(const GlTexture& texture, int width, int height, const unsigned char* rgba) {
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindTexture(GL_TEXTURE_2D, texture.name());
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

/// Ids are names of textures, such as a font's, none for a font that has no name yet, or addresses of sheets,
/// whose textures are made and brought up to date here.
GLuint ImGuiRenderer::texture_of(ImTextureID id) {
    constexpr std::uintptr_t lowest_address = 1 << 16; // no object is below, and few textures have such names
    const auto name = reinterpret_cast<std::uintptr_t>(id);
    if (name < lowest_address) return name == 0 ? font_.name() : static_cast<GLuint>(name);
    std::erase_if(sheets_, [](const Sheet& one) { return one.of.expired(); });
    const auto& sheet = *static_cast<const PictureSheet*>(id);
    auto found = std::find_if(sheets_.begin(), sheets_.end(),
                              [&](const Sheet& one) { return one.of.lock().get() == &sheet; });
    if (found == sheets_.end()) {
        sheets_.push_back({sheet.weak_from_this(), GlTexture(gl_)});
        found = std::prev(sheets_.end());
    }
    if (found->version != sheet.version()) {
        upload(found->texture, sheet.image().width, sheet.image().height, sheet.image().rgba.data());
        found->version = sheet.version();
    }
    return found->texture.name();
}

void ImGuiRenderer::set_state(const ImDrawData& data, int width, int height) {
    gl_.Viewport(0, 0, width, height);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl_.Disable(GL_CULL_FACE);
    gl_.Disable(GL_DEPTH_TEST);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.UseProgram(program_.name());
    const ImVec2 low = data.DisplayPos;
    const ImVec2 high = {low.x + data.DisplaySize.x, low.y + data.DisplaySize.y};
    const glm::mat4 clip = glm::ortho(low.x, high.x, high.y, low.y);
    gl_.UniformMatrix4fv(clip_, 1, GL_FALSE, glm::value_ptr(clip));
    gl_.ActiveTexture(GL_TEXTURE0);
    gl_.BindVertexArray(array_.name());
    gl_.BindBuffer(GL_ARRAY_BUFFER, vertices_.name()); // not part of the vertex array's state
}

void ImGuiRenderer::draw_list(const ImDrawList& list, const ImDrawData& data, PixelRect part, int height) {
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.VtxBuffer.size_in_bytes()),
                   list.VtxBuffer.Data, GL_STREAM_DRAW);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(list.IdxBuffer.size_in_bytes()),
                   list.IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list.CmdBuffer) {
        if (command.UserCallback != nullptr) {
            // The one special value asks for our own state again; others draw by themselves.
            if (command.UserCallback == ImDrawCallback_ResetRenderState)
                set_state(data, static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x), height);
            else
                command.UserCallback(&list, &command);
            continue;
        }
        const auto x = [&](float value) {
            return static_cast<int>((value - data.DisplayPos.x) * data.FramebufferScale.x);
        };
        const auto y = [&](float value) {
            return static_cast<int>((value - data.DisplayPos.y) * data.FramebufferScale.y);
        };
        const int left = x(command.ClipRect.x), top = y(command.ClipRect.y);
        const PixelRect seen =
            intersection(part, {left, top, x(command.ClipRect.z) - left, y(command.ClipRect.w) - top});
        if (seen.empty()) continue;
        gl_.Scissor(seen.x, height - seen.y - seen.height, seen.width, seen.height);
        gl_.BindTexture(GL_TEXTURE_2D, texture_of(command.GetTexID()));
        gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                   sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                   offset(command.IdxOffset * sizeof(ImDrawIdx)),
                                   static_cast<GLint>(command.VtxOffset));
    }
}

void ImGuiRenderer::draw(const ImDrawData& data, PixelRect part) {
    const int width = static_cast<int>(data.DisplaySize.x * data.FramebufferScale.x);
    const int height = static_cast<int>(data.DisplaySize.y * data.FramebufferScale.y);
    if (width <= 0 || height <= 0) return; // minimised
    set_state(data, width, height);
    part = intersection(part, {0, 0, width, height});
    for (int i = 0; i < data.CmdListsCount; ++i)
        if (!intersection(part, area_of(*data.CmdLists[i], data)).empty())
            draw_list(*data.CmdLists[i], data, part, height);
    gl_.Disable(GL_SCISSOR_TEST);
}

} // namespace gaspard
