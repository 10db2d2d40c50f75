#version 330 core
// Light and dark ink over what is below, each as strong as the layer says.
uniform sampler2D ink;  // red: light ink, green: dark ink
uniform vec2 corner;    // lower left of the viewport
uniform vec4 light_ink;
uniform vec4 dark_ink;

// Light adds up linearly, sRGB does not: half a pixel of light ink on a dark ground needs more than half of
// the way from one sRGB value to the other, and dark ink on a light ground less. Powers that come near, for
// the two themes.
const vec2 evening = vec2(0.62, 1.35);

out vec4 colour;

void main() {
    vec2 covered = texelFetch(ink, ivec2(gl_FragCoord.xy - corner), 0).rg;
    if (covered.r + covered.g == 0.0) discard;
    vec2 amount = pow(covered, evening) * vec2(light_ink.a, dark_ink.a);
    float alpha = amount.r + amount.g * (1.0 - amount.r);
    if (alpha <= 0.0) discard;
    vec3 mixed = light_ink.rgb * amount.r + dark_ink.rgb * amount.g * (1.0 - amount.r);
    colour = vec4(mixed / alpha, alpha);
}
