#version 330 core
// A shaft and a head with a rim, smooth at the edges. Arrows shorter than a pixel or two fade away.
uniform vec4 ink;
uniform vec4 rim;
uniform float shaft_width; // half of it, in pixels
uniform float head_width;
uniform float rim_width;

noperspective in vec2 place;
flat in float arrow_length;
out vec4 colour;

/// Distance to the arrow's outline in pixels, negative inside.
float outside() {
    float head = min(2.6 * head_width, 0.7 * arrow_length);
    float wide = head_width * head / (2.6 * head_width);
    float shaft = max(max(-place.x, place.x - (arrow_length - head)), abs(place.y) - min(shaft_width, wide));
    vec2 normal = normalize(vec2(wide, max(head, 1e-3))); // of the head's upper side
    float tip = max(dot(vec2(place.x - arrow_length, abs(place.y)), normal), (arrow_length - head) - place.x);
    return min(shaft, tip);
}

void main() {
    float away = outside();
    float strength = smoothstep(1.0, 3.0, arrow_length);
    float inner = clamp(0.5 - away, 0.0, 1.0), outer = clamp(0.5 + rim_width - away, 0.0, 1.0) * rim.a;
    float alpha = max(inner, outer) * strength;
    if (alpha <= 0.0) discard;
    colour = vec4(mix(rim.rgb, ink.rgb, inner), alpha);
}
