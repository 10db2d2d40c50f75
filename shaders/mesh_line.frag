#version 330 core
// Coverage of a pixel by a line with round ends. Into a LineLayer: light ink on dark colours, dark ink on
// light ones. Straight into a picture: one ink for all, or the colour map.
#include "colour_map.glsl"
uniform bool by_map;
uniform vec4 surface; // as in mesh_fill.frag
uniform vec4 flat_ink; // straight into a picture if its alpha is above zero
uniform vec4 ink_on_light; // instead of flat_ink on light colours, if its alpha is above zero
uniform float half_width;

noperspective in vec2 place;
noperspective in float value;
noperspective in float turned;
flat in float line_length;
flat in float strength;
flat in float softness;
flat in vec3 tint;
out vec4 colour;

/// How much of a pixel lies on one side of an edge that is so far beyond its middle. A pixel is a square, or
/// when soft a tent over two: with either, a line sheds the same ink on the pixels across it wherever it lies
/// between them.
float part(float beyond) {
    float hard = clamp(beyond + 0.5, 0.0, 1.0);
    float x = clamp(beyond, -1.0, 1.0);
    float tent = x < 0.0 ? 0.5 * (1.0 + x) * (1.0 + x) : 1.0 - 0.5 * (1.0 - x) * (1.0 - x);
    return mix(hard, tent, softness);
}

void main() {
    vec2 nearest = vec2(clamp(place.x, 0.0, line_length), 0.0);
    float away = distance(place, nearest);
    float coverage = strength * (part(half_width - away) - part(-half_width - away));
    bool beside = place.x >= 0.0 && place.x <= line_length && place.y * tint.z >= 0.0;
    if (beside && away <= tint.x) coverage = max(coverage, tint.y);
    coverage *= turned;
    vec3 below = surface.a > 0.0 ? surface.rgb : colour_of(value);
    float light = smoothstep(0.5, 0.6, dot(below, vec3(0.299, 0.587, 0.114)));
    if (flat_ink.a > 0.0) {
        vec4 ink = ink_on_light.a > 0.0 ? mix(flat_ink, ink_on_light, light) : flat_ink;
        colour = vec4(by_map ? colour_of(value) : ink.rgb, ink.a * coverage);
        return;
    }
    colour = vec4(coverage * (1.0 - light), coverage * light, 0.0, 0.0);
}
