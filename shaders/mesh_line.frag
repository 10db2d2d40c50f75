#version 330 core
// Coverage of a pixel by a line with round ends; light ink on dark colours, dark ink on light ones.
uniform sampler2D colours;
uniform vec4 surface; // as in mesh_fill.frag
uniform vec4 ink_on_dark;
uniform vec4 ink_on_light;
uniform vec4 flat_ink; // used instead where its alpha is above zero
uniform float half_width;

noperspective in vec2 place;
noperspective in float scalar;
flat in float line_length;
flat in float strength;
out vec4 colour;

void main() {
    vec2 nearest = vec2(clamp(place.x, 0.0, line_length), 0.0);
    float coverage = clamp(half_width + 0.5 - distance(place, nearest), 0.0, 1.0) * min(2.0 * half_width, 1.0);

    float last = float(textureSize(colours, 0).x) - 1.0;
    float position = (clamp(scalar, 0.0, 1.0) * last + 0.5) / (last + 1.0);
    vec3 below = surface.a > 0.0 ? surface.rgb : texture(colours, vec2(position, 0.5)).rgb;
    float brightness = dot(below, vec3(0.299, 0.587, 0.114));
    vec4 ink = mix(ink_on_dark, ink_on_light, smoothstep(0.5, 0.6, brightness));
    if (flat_ink.a > 0.0) ink = flat_ink;
    colour = vec4(ink.rgb, ink.a * coverage * strength);
}
