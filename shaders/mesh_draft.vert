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
out vec3 away;    // from the edges ab, ac, bc in pixels
out float turned; // as in mesh_line.vert
out float light;
flat out vec3 strength;
flat out vec3 softness;
flat out float tint; // what vanished lines leave

vec4 shown(uint number) {
    vec4 to = row(physical, int(number));
    return blend >= 1.0 ? to : vec4(between(row(computational, int(number)).xyz, to.xyz), to.w);
}

vec2 pixels(vec4 place) { return place.xy * clip_to_pixels.xy; }

/// Of a half: 1 for each of ab, ac, bc on an edge.
vec3 sides_on_edges(int facet, int which) {
    if (cuts == 1) return vec3(1.0);
    uint sides = texelFetch(edges, ivec2(facet & 2047, facet >> 11), 0).r;
    if (!quadrilaterals) return vec3(sides & 1u, (sides >> 2) & 1u, (sides >> 1) & 1u);
    if (which == 0) return vec3(sides & 1u, (sides >> 3) & 1u, 0.0);
    return vec3((sides >> 2) & 1u, (sides >> 1) & 1u, 0.0);
}

void main() {
    int half_facet = gl_VertexID / 3, corner = gl_VertexID - 3 * half_facet;
    int facet = quadrilaterals ? half_facet >> 1 : half_facet;
    uvec4 points = texelFetch(facets, ivec2(facet & 2047, facet >> 11), 0);
    uvec3 ends = !quadrilaterals ? points.xyz : (half_facet & 1) == 0 ? points.xyw : points.zwy;
    vec4 a = shown(ends.x), b = shown(ends.y), c = shown(ends.z);
    vec4 own = corner == 0 ? a : corner == 1 ? b : c;
    vec4 clip_a = clip * vec4(a.xyz, 1.0), clip_b = clip * vec4(b.xyz, 1.0), clip_c = clip * vec4(c.xyz, 1.0);
    gl_Position = corner == 0 ? clip_a : corner == 1 ? clip_b : clip_c;

    vec3 ab = (clip_b - clip_a).xyz * clip_to_pixels, ac = (clip_c - clip_a).xyz * clip_to_pixels;
    float area = abs(ab.x * ac.y - ab.y * ac.x); // of both halves
    vec3 lengths = max(vec3(length(ab.xy), length(ac.xy), distance(ab.xy, ac.xy)), 1e-3);
    vec3 heights = area / lengths;
    away = heights * vec3(corner == 2, corner == 1, corner == 0);
    vec3 spacing = heights * float(cuts), crossing = lengths * float(cuts);
    strength = smoothstep(fade.x, fade.y, spacing);
    softness = 1.0 - smoothstep(1.5 * fade.y, 3.0 * fade.y, spacing);
    vec3 vanished = 2.0 * half_width * ((1.0 - strength) / max(spacing, 1e-3) +
                                        (1.0 - smoothstep(fade.x, fade.y, crossing)) / crossing);
    strength *= sides_on_edges(facet, half_facet & 1);
    if (quadrilaterals) strength.z = vanished.z = 0.0; // bc is no edge
    float most = max(max(vanished.x, vanished.y), vanished.z);
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
    vec3 normal = cross(ab, ac);
    float facing = round_cells ? dot(normalize(own.xyz - ball.xyz), viewer)
                               : abs(normal.z) / max(length(normal), 1e-20);
    facing = clamp(facing, 0.0, 1.0);
    light = dusk > 0.0 ? 1.0 - dusk * pow(1.0 - facing, 1.6) : 1.0;
}
