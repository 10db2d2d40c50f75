#include "gui/render/texel_table.hpp"

namespace gaspard {

namespace {

constexpr std::size_t table_width = 2048; // as in the shaders

} // namespace

std::size_t TexelTable::fill(const Gl& gl, const TexelFormat& texel, const void* texels, std::size_t count) {
    const auto rows = static_cast<int>((count + table_width - 1) / table_width);
    const auto width = static_cast<GLsizei>(table_width);
    gl.ActiveTexture(GL_TEXTURE0);
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    if (texture_.name() == 0) texture_ = GlTexture(gl);
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
    if (rows > rows_) {
        gl.TexImage2D(GL_TEXTURE_2D, 0, texel.internal, width, rows, 0, texel.format, texel.type, nullptr);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        rows_ = rows;
    }
    const auto full = static_cast<GLsizei>(count / table_width),
               rest = static_cast<GLsizei>(count % table_width);
    const auto* bytes = static_cast<const unsigned char*>(texels);
    if (full > 0) gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, full, texel.format, texel.type, bytes);
    if (rest > 0)
        gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, full, rest, 1, texel.format, texel.type,
                         bytes + static_cast<std::size_t>(full) * table_width * texel.bytes);
    return count * texel.bytes;
}

void TexelTable::bind(const Gl& gl, int unit) const {
    gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    gl.BindTexture(GL_TEXTURE_2D, texture_.name());
}

} // namespace gaspard
