#include "gui/gl/gl_objects.hpp"

#include "core/base/check.hpp"
#include "gui_assets.hpp"

namespace gaspard {

namespace {

std::string_view shader_source(const std::string& path) {
    for (const auto& file : gui_assets::files())
        if (file.path == path) return file.bytes;
    check_failed("the shader is embedded");
}

/// GLSL has no includes: a line #include "name.glsl" is replaced by that file.
std::string with_includes(std::string_view source) {
    constexpr std::string_view begin = "#include \"";
    std::string text(source);
    for (std::size_t at = 0; (at = text.find(begin, at)) != text.npos;) {
        const std::size_t name = at + begin.size(), end = text.find('"', name);
        text.replace(at, end + 1 - at, shader_source("shaders/" + text.substr(name, end - name)));
    }
    return text;
}

GlShader compile(const Gl& gl, GLenum stage, const std::string& path) {
    const std::string source = with_includes(shader_source(path));
    GlShader shader(gl, gl.CreateShader(stage));
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    gl.ShaderSource(shader.name(), 1, &text, &length);
    gl.CompileShader(shader.name());
    GLint good = 0;
    gl.GetShaderiv(shader.name(), GL_COMPILE_STATUS, &good);
    if (good != 0) return shader;
    std::string log(2000, '\0');
    GLsizei written = 0;
    gl.GetShaderInfoLog(shader.name(), static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    throw MachineError("this machine's OpenGL does not compile " + path + ": " + log);
}

} // namespace

GlProgram make_program(const Gl& gl, std::string_view vertex, std::string_view fragment) {
    const GlShader first = compile(gl, GL_VERTEX_SHADER, "shaders/" + std::string(vertex) + ".vert");
    const GlShader second = compile(gl, GL_FRAGMENT_SHADER, "shaders/" + std::string(fragment) + ".frag");
    GlProgram program(gl);
    gl.AttachShader(program.name(), first.name());
    gl.AttachShader(program.name(), second.name());
    gl.LinkProgram(program.name());
    GLint good = 0;
    gl.GetProgramiv(program.name(), GL_LINK_STATUS, &good);
    if (good != 0) return program;
    std::string log(2000, '\0');
    GLsizei written = 0;
    gl.GetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    throw MachineError("this machine's OpenGL does not link the shaders " + std::string(vertex) + ": " + log);
}

GLint uniform(const Gl& gl, const GlProgram& program, const char* name) {
    return gl.GetUniformLocation(program.name(), name);
}

} // namespace gaspard
