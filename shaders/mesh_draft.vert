#version 330 core
// A corner of a triangle of a mesh that moves: cells and their edges are drawn at once, straight from the
// facets, each corner with its place in the colour map and its distances from the edges.
#include "place.glsl"
uniform usampler2D facets; // four shown points around a quadrilateral; a triangle repeats its last one
uniform bool quadrilaterals; // in two halves each
uniform int cuts;            // pieces of an edge of a cell
uniform usampler2D edges;    // if there are several: which sides of a facet lie on edges (facets.hpp)
uniform bool flat_cells;        // each cell has a value of its own
uniform usampler2D shown_cells; // which cell a triangle belongs to
uniform sampler2D cell_values;
uniform float logarithm; // as in colour_map.glsl
uniform mat4 clip;
uniform vec3 clip_to_pixels;
uniform float half_width; // of a line, in pixels
uniform vec2 fade;        // this and the next as in mesh_line.vert
uniform float haze;
uniform vec3 viewer;
uniform vec2 limb;
uniform float dusk;       // this and the next as in mesh_fill.frag
uniform bool round_cells;

out float place;  // along the colour map, 0 to 1
out vec4 away;    // from the sides of the facet in pixels: from point 0 to 1, from 1 to 2, ...
out float turned; // as in mesh_line.vert
out float light;
flat out vec4 strength;
flat out vec4 softness;
flat out float tint; // what vanished lines leave

vec4 shown(uint number) {
    vec4 to = row(physical, int(number));
    return blend >= 1.0 ? to : vec4(between(row(computational, int(number)).xyz, to.xyz), to.w);
}

vec4 on_screen(vec4 point) { return clip * vec4(point.xyz, 1.0); }

/// The distance of c from the line through a and b, which are so far apart.
float beyond(vec2 a, vec2 b, vec2 c, float apart) {
    vec2 along = b - a, to = c - a;
    return abs(along.x * to.y - along.y * to.x) / apart;
}

vec4 bits(uint flags, uvec4 which) { return vec4((uvec4(flags) >> which) & 1u); }

void main() {
    int half_facet = gl_VertexID / 3, corner = gl_VertexID - 3 * half_facet;
    int facet = quadrilaterals ? half_facet >> 1 : half_facet;
    bool far_half = quadrilaterals && (half_facet & 1) == 1;
    uvec4 points = texelFetch(facets, ivec2(facet & 2047, facet >> 11), 0);
    vec4 p0 = shown(points.x), p1 = shown(points.y), p2 = shown(points.z), p3 = shown(points.w);
    vec4 c0 = on_screen(p0), c1 = on_screen(p1), c2 = on_screen(p2), c3 = on_screen(p3);
    // The halves 0 1 3 and 2 3 1 of a quadrilateral, or the triangle 0 1 2.
    vec4 own = corner == 0 ? (far_half ? p2 : p0) : corner == 1 ? (far_half ? p3 : p1)
                                                  : (far_half ? p1 : quadrilaterals ? p3 : p2);
    vec4 first = far_half ? c2 : c0, second = far_half ? c3 : c1;
    vec4 third = far_half ? c1 : quadrilaterals ? c3 : c2;
    gl_Position = corner == 0 ? first : corner == 1 ? second : third;

    vec2 scale = clip_to_pixels.xy, o = gl_Position.xy * scale;
    vec2 a = c0.xy * scale, b = c1.xy * scale, c = c2.xy * scale, d = c3.xy * scale;
    vec4 lengths, heights; // of the sides, and of what lies across
    if (quadrilaterals) {
        lengths = max(vec4(distance(a, b), distance(b, c), distance(c, d), distance(d, a)), 1e-3);
        heights = 0.5 * vec4(beyond(a, b, c, lengths.x) + beyond(a, b, d, lengths.x),
                             beyond(b, c, d, lengths.y) + beyond(b, c, a, lengths.y),
                             beyond(c, d, a, lengths.z) + beyond(c, d, b, lengths.z),
                             beyond(d, a, b, lengths.w) + beyond(d, a, c, lengths.w));
        away = vec4(beyond(a, b, o, lengths.x), beyond(b, c, o, lengths.y), beyond(c, d, o, lengths.z),
                    beyond(d, a, o, lengths.w));
    } else {
        lengths = vec4(max(vec3(distance(a, b), distance(b, c), distance(c, a)), 1e-3), 1e6);
        heights = vec4(beyond(a, b, c, lengths.x), beyond(b, c, a, lengths.y), beyond(c, a, b, lengths.z), 1e6);
        away = vec4(beyond(a, b, o, lengths.x), beyond(b, c, o, lengths.y), beyond(c, a, o, lengths.z), 1e6);
    }
    vec4 spacing = heights * float(cuts), crossing = lengths * float(cuts);
    strength = smoothstep(fade.x, fade.y, spacing);
    softness = 1.0 - smoothstep(1.5 * fade.y, 3.0 * fade.y, spacing);
    vec4 vanished = 2.0 * half_width * ((1.0 - strength) / max(spacing, 1e-3) +
                                        (1.0 - smoothstep(fade.x, fade.y, crossing)) / crossing);
    float most = max(max(vanished.x, vanished.y), max(vanished.z, vanished.w));
    if (cuts > 1) {
        uint flags = texelFetch(edges, ivec2(facet & 2047, facet >> 11), 0).r;
        // A triangle that touches an edge with a corner is as far from it as from a parallel to the side
        // opposite.
        vec4 touches = bits(flags, uvec4(6u, 4u, 5u, 7u));
        away = mix(away, heights - away, touches);
        strength *= max(bits(flags, uvec4(0u, 1u, 2u, 3u)), touches);
    }
    tint = haze * most / (1.0 + most);
    turned = ball.w > 0.0 && limb.y > limb.x
                 ? smoothstep(limb.x, limb.y, dot(normalize(own.xyz - ball.xyz), viewer))
                 : 1.0;

    place = own.w;
    if (flat_cells) {
        uint cell = texelFetch(shown_cells, ivec2(half_facet & 2047, half_facet >> 11), 0).r;
        place = row(cell_values, int(cell)).r;
    }
    if (logarithm > 0.0) place = log(1.0 + max(place, 0.0) * (exp(logarithm) - 1.0)) / logarithm;
    vec3 normal = cross((second - first).xyz * clip_to_pixels, (third - first).xyz * clip_to_pixels);
    float facing = round_cells ? dot(normalize(own.xyz - ball.xyz), viewer)
                               : abs(normal.z) / max(length(normal), 1e-20);
    facing = clamp(facing, 0.0, 1.0);
    light = dusk > 0.0 ? 1.0 - dusk * pow(1.0 - facing, 1.6) : 1.0;
}
