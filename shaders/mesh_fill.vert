#version 330 core
// A shown point on its way from xi to x.
#include "place.glsl"
uniform mat4 clip;
uniform vec3 clip_to_pixels;

out float value;
out vec3 pixel; // the same point in pixels, for its normal
out vec3 outward; // from the ball's centre

void main() {
    vec4 to = row(physical, gl_VertexID);
    vec3 point = between(row(computational, gl_VertexID).xyz, to.xyz);
    gl_Position = clip * vec4(point, 1.0);
    outward = point - ball.xyz;
    value = to.w;
    pixel = gl_Position.xyz * clip_to_pixels;
}
