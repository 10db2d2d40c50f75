#version 330 core
// The inside of cells: a colour map or one colour, darker where the surface turns away from the viewer.
uniform sampler2D colours;
uniform vec4 surface; // used where its alpha is above zero

in float scalar;
in vec3 pixel;
out vec4 colour;

void main() {
    float last = float(textureSize(colours, 0).x) - 1.0;
    float position = (clamp(scalar, 0.0, 1.0) * last + 0.5) / (last + 1.0);
    vec3 base = surface.a > 0.0 ? surface.rgb : texture(colours, vec2(position, 0.5)).rgb;
    vec3 normal = cross(dFdx(pixel), dFdy(pixel));
    float facing = abs(normal.z) / max(length(normal), 1e-20);
    colour = vec4(base * mix(0.45, 1.0, facing), 1.0);
}
