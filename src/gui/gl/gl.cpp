#include "gui/gl/gl.hpp"

#include "core/base/error.hpp"
#include "gui/gl/gl_functions.hpp"

#include <string>
#include <string_view>

namespace gaspard {

namespace {

template <class Function>
void load(const GlLookup& lookup, Function& function, const char* name) {
    void* address = lookup(name);
    if (address == nullptr)
        throw MachineError(std::string("this machine's OpenGL lacks the function ") + name +
                           "; Gaspard needs OpenGL 3.3 or newer");
    function = reinterpret_cast<Function>(address);
}

void require_version(const Gl& gl) {
    GLint major = 0, minor = 0;
    gl.GetIntegerv(GL_MAJOR_VERSION, &major);
    gl.GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33)
        throw MachineError("this machine offers OpenGL " + std::to_string(major) + "." +
                           std::to_string(minor) + "; Gaspard needs 3.3 or newer");
}

} // namespace

Gl load_gl(const GlLookup& lookup) {
    Gl gl;
    visit_gl_functions(gl, [&](auto& function, const char* name) { load(lookup, function, name); });
    require_version(gl);
    return gl;
}

bool draws_in_software(const Gl& gl) {
    const auto* text = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    const std::string_view renderer = text ? text : "";
    return renderer.find("llvmpipe") != renderer.npos || renderer.find("softpipe") != renderer.npos ||
           renderer.find("Software Rasterizer") != renderer.npos;
}

} // namespace gaspard
