#version 330 core
// A corner of a facet on its way from xi to x.
#include "place.glsl"
uniform usampler2D facets; // four shown points around a quadrilateral; a triangle repeats its last one
uniform bool nodal;        // values are those of points, and bilinear in a quadrilateral
uniform mat4 clip;
uniform vec3 clip_to_pixels;

out float value;
out vec2 inside; // from (0, 0) at the facet's first point to (1, 1) at its third, linear in each half
flat out vec3 bend; // of its half: what nodal_value() needs
flat out float far_half;
out vec3 pixel; // the same point in pixels, for its normal
out vec3 outward; // from the ball's centre

vec4 shown(uint number) {
    vec4 to = row(physical, int(number));
    return blend >= 1.0 ? to : vec4(between(row(computational, int(number)).xyz, to.xyz), to.w);
}

/// A half has the corner a and its neighbours b and c; d is opposite. Bilinear in the quadrilateral are
///
///   p = a + s (b - a) + t (c - a) + s t g,   g = a - b - c + d = alpha (b - a) + beta (c - a),
///
/// and the values likewise. Gives alpha, beta and what s t is multiplied by in the value when s and t are
/// written with the linear coordinates (s + alpha s t, t + beta s t) of p.
vec3 bend_of(vec4 a, vec4 b, vec4 c, vec4 d) {
    vec4 first = b - a, second = c - a, g = a - b - c + d;
    float ff = dot(first.xyz, first.xyz), fs = dot(first.xyz, second.xyz), ss = dot(second.xyz, second.xyz);
    float gf = dot(g.xyz, first.xyz), gs = dot(g.xyz, second.xyz);
    float area = ff * ss - fs * fs; // its square
    vec2 part = area > 1e-9 * ff * ss ? vec2(gf * ss - gs * fs, gs * ff - gf * fs) / area : vec2(0.0);
    return vec3(part, g.w - part.x * first.w - part.y * second.w);
}

void main() {
    int facet = gl_VertexID >> 2, corner = gl_VertexID & 3;
    uvec4 points = texelFetch(facets, ivec2(facet & 2047, facet >> 11), 0);
    vec4 point = shown(points[corner]);
    gl_Position = clip * vec4(point.xyz, 1.0);
    outward = point.xyz - ball.xyz;
    value = point.w;
    inside = vec2(corner == 1 || corner == 2, corner >= 2);
    pixel = gl_Position.xyz * clip_to_pixels;
    // The half at the first point ends with corner 3, which gives its flat values; the half at the third with
    // corner 1.
    far_half = corner == 1 ? 1.0 : 0.0;
    bend = vec3(0.0);
    if (nodal && points.z != points.w && (corner & 1) == 1) {
        vec4 before = shown(points[(corner + 3) & 3]), opposite = shown(points[(corner + 2) & 3]),
             after = shown(points[(corner + 1) & 3]);
        bend = bend_of(after, opposite, point, before);
    }
}
