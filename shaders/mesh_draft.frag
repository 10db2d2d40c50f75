#version 330 core
// A cell and its half of the edges around it.
uniform sampler2D colours;
uniform vec4 surface; // used where its alpha is above zero
uniform float half_width;
uniform vec4 light_ink; // no lines if its alpha and the next one's are zero
uniform vec4 dark_ink;

in float place;
in vec4 away;
in float turned;
in float light;
flat in vec4 strength;
flat in vec4 softness;
flat in float tint;
out vec4 colour;

/// As in mesh_line.frag, for four edges.
vec4 part(vec4 beyond) {
    vec4 x = clamp(beyond, -1.0, 1.0);
    return mix(clamp(beyond + 0.5, 0.0, 1.0), 0.5 + x - 0.5 * x * abs(x), softness);
}

/// `place` is in the map already, unlike in colour_map.glsl.
vec3 colour_of(float place) {
    float last = float(textureSize(colours, 0).x) - 1.0;
    return texture(colours, vec2((clamp(place, 0.0, 1.0) * last + 0.5) / (last + 1.0), 0.5)).rgb;
}

void main() {
    vec4 lines = strength * (part(half_width - away) - part(-half_width - away));
    float coverage = turned * max(max(max(lines.x, lines.y), max(lines.z, lines.w)), tint);
    vec3 base = surface.a > 0.0 ? surface.rgb : colour_of(place);
    float dark = coverage * smoothstep(0.5, 0.6, dot(base, vec3(0.299, 0.587, 0.114)));
    float bright = coverage - dark;
    // As in line_layer.frag; its powers .62 and 1.35 within .012.
    float root = sqrt(bright), deep = sqrt(dark);
    bright = light_ink.a * root * mix(1.0, sqrt(root), 0.47);
    dark = dark_ink.a * dark * mix(sqrt(deep), deep, 0.39);
    colour = vec4(mix(mix(base * light, dark_ink.rgb, dark), light_ink.rgb, bright), 1.0);
}
