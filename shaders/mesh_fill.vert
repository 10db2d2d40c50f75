#version 330 core
// A shown point on its way from xi to x. Points are fetched by number from tables that are 2048 texels wide.
uniform sampler2D computational; // xi relative to the picture's centre
uniform sampler2D physical;      // x likewise; w: where the value lies in the range of colours, 0 to 1
uniform mat4 clip;
uniform float blend;
uniform vec3 clip_to_pixels;

out float value;
out vec3 pixel; // the same point in pixels, for its normal

vec4 row(sampler2D table, int i) { return texelFetch(table, ivec2(i & 2047, i >> 11), 0); }

void main() {
    vec4 to = row(physical, gl_VertexID);
    gl_Position = clip * vec4(mix(row(computational, gl_VertexID).xyz, to.xyz, blend), 1.0);
    value = to.w;
    pixel = gl_Position.xyz * clip_to_pixels;
}
