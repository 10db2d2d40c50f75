#version 330 core
// A cell's edge as a rectangle on the screen, a little wider than the line, whose fragments know their
// distance from it. Six vertices (two triangles) per segment; a segment of no length becomes a disc.
#include "place.glsl"
uniform usampler2D segments; // two points, and two at the far sides of the cells beside
uniform bool flat_cells;         // as in mesh_fill.frag; of cells that are lines
uniform usampler2D shown_cells; // which cell a segment belongs to
uniform sampler2D cell_values;
uniform mat4 clip;
uniform vec2 half_viewport; // half its size in pixels
uniform float half_width;   // of the line, in pixels
uniform vec2 fade;          // lines closer together than .x pixels vanish, beyond .y they are whole
uniform float haze;         // how strongly an even tint, as dense as the lines, takes the place of vanished
                            // ones
uniform float pieces;       // of an edge: how many segments it is drawn with
uniform float pull;         // towards the viewer, in clip coordinates, so that faces do not hide their own
                            // edges
uniform vec3 viewer;        // as in mesh_fill.frag
uniform float bent;         // of a map, which bends lines so that those ahead of one may be far: the least
                            // part of the distance to the far side that counts as spacing
uniform vec2 limb;          // on a ball that turns away lines fade: gone at the cosine .x, whole from .y on

noperspective out vec2 place; // in pixels from the first point: along the line, across it
noperspective out float value; // where it lies in the range of colours
noperspective out float turned; // 0 to 1: what is left of the line where the ball turns away
flat out float line_length;
flat out float strength;
flat out float softness; // 0 to 1: close lines are softer, so that none beat
flat out vec3 tint; // half the width of the band it fills, its amount; at a border: on which side (1 or -1)

vec3 point(uint i) { return between(row(computational, int(i)).xyz, row(physical, int(i)).xyz); }
vec3 clip_point(uint i) { return (clip * vec4(point(i), 1.0)).xyz; }

/// Of a ball's cell that goes on behind the limb nobody sees how far it reaches.
float seen_spacing(uint far, vec2 from, vec2 across) {
    bool behind = ball.w > 0.0 && dot(point(far) - ball.xyz, viewer) < 0.0;
    vec2 away = clip_point(far).xy * half_viewport - from;
    return behind ? 1e6 : max(abs(dot(away, across)), bent * length(away));
}

void main() {
    int segment = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    vec2 side = vec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);

    uvec4 ends = texelFetch(segments, ivec2(segment & 2047, segment >> 11), 0);
    vec3 first_end = point(ends.x), second_end = point(ends.y);
    vec3 a = (clip * vec4(first_end, 1.0)).xyz, b = (clip * vec4(second_end, 1.0)).xyz;
    vec2 from = a.xy * half_viewport, to = b.xy * half_viewport;
    line_length = distance(from, to);
    vec2 along = line_length > 0.0 ? (to - from) / line_length : vec2(1.0, 0.0);
    vec2 across = vec2(-along.y, along.x);

    strength = 1.0;
    softness = 0.0;
    tint = vec3(0.0);
    if (ends.z != ends.x) {
        float first = dot(clip_point(ends.z).xy * half_viewport - from, across);
        float spacing = min(seen_spacing(ends.z, from, across), seen_spacing(ends.w, from, across));
        strength = smoothstep(fade.x, fade.y, spacing);
        softness = 1.0 - smoothstep(1.5 * fade.y, 3.0 * fade.y, spacing);
        // The lines that cross here stand about as close as this edge is long. What has vanished of both
        // lines tints the cells; the tint grows with the lines' density, but never so far that denser ones
        // could not be told.
        float crossing = line_length * pieces;
        float vanished = 2.0 * half_width * ((1.0 - strength) / max(spacing, 1e-3) +
                                             (1.0 - smoothstep(fade.x, fade.y, crossing)) / max(crossing, 1e-3));
        tint = vec3(0.6 * min(spacing, fade.y) + 0.1, haze * vanished / (1.0 + vanished),
                    ends.z == ends.w ? sign(first) : 0.0);
    }

    vec3 end = (side.x > 0.5 ? second_end : first_end) - ball.xyz;
    turned = ball.w > 0.0 && limb.y > limb.x ? smoothstep(limb.x, limb.y, dot(normalize(end), viewer)) : 1.0;

    float reach = 1.0 + max(half_width, tint.y > 0.0 ? tint.x : 0.0);
    place = vec2(mix(-reach, line_length + reach, side.x), mix(-reach, reach, side.y));
    vec2 spot = from + along * place.x + across * place.y;
    float t = line_length > 0.0 ? clamp(place.x / line_length, 0.0, 1.0) : 0.0;
    value = flat_cells ? row(cell_values, int(texelFetch(shown_cells, ivec2(segment & 2047, segment >> 11), 0).r)).r
                       : mix(row(physical, int(ends.x)).w, row(physical, int(ends.y)).w, t);
    gl_Position = vec4(spot / half_viewport, mix(a.z, b.z, t) - pull, 1.0);
}
