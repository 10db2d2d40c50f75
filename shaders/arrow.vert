#version 330 core
// An arrow from xi to x of one shown point, as a rectangle on the screen whose fragments know where in it
// they are. Six vertices (two triangles) per arrow.
#include "place.glsl"
uniform usampler2D segments; // one shown point each
uniform mat4 clip;
uniform vec2 half_viewport; // half its size in pixels
uniform float head_width;   // half of it, in pixels
uniform float pull;         // towards the viewer, in clip coordinates, so that no surface between the ends
                            // hides it

noperspective out vec2 place; // in pixels from xi: along the arrow, across it
flat out float arrow_length;

void main() {
    int arrow = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    vec2 side = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);

    uint point = texelFetch(segments, ivec2(arrow & 2047, arrow >> 11), 0).r;
    vec4 a = clip * vec4(row(computational, int(point)).xyz, 1.0), b = clip * vec4(row(physical, int(point)).xyz, 1.0);
    vec2 from = a.xy * half_viewport, to = b.xy * half_viewport;
    arrow_length = distance(from, to);
    vec2 along = arrow_length > 0.0 ? (to - from) / arrow_length : vec2(1.0, 0.0);
    float reach = head_width + 3.0;
    place = vec2(mix(-reach, arrow_length + reach, side.x), mix(-reach, reach, side.y));
    vec2 spot = from + along * place.x + vec2(-along.y, along.x) * place.y;
    float t = arrow_length > 0.0 ? clamp(place.x / arrow_length, 0.0, 1.0) : 0.0;
    gl_Position = vec4(spot / half_viewport, mix(a.z, b.z, t) - pull, 1.0);
}
