#version 330 core
// ImGui's triangles: positions in its own units, upper left corner first.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texel;
layout(location = 2) in vec4 tint;
uniform mat4 clip;

out vec2 texel_here;
out vec4 tint_here;

void main() {
    texel_here = texel;
    tint_here = tint;
    gl_Position = clip * vec4(position, 0.0, 1.0);
}
