#version 330 core
// A shown point on its way from xi to x. Points are fetched by number from tables that are 2048 texels wide.
uniform sampler2D computational; // xi relative to the picture's centre
uniform sampler2D physical;      // x likewise; w: where the value lies in the range of colours, 0 to 1
uniform mat4 clip;
uniform float blend;
uniform vec3 clip_to_pixels;
uniform vec4 ball; // centre and radius of the sphere that the nodes lie on; radius 0: they lie on none

out float value;
out vec3 pixel; // the same point in pixels, for its normal
out vec3 outward; // from the ball's centre

vec4 row(sampler2D table, int i) { return texelFetch(table, ivec2(i & 2047, i >> 11), 0); }

/// Half way is on the ball too.
vec3 between(vec3 from, vec3 to) {
    vec3 straight = mix(from, to, blend);
    if (ball.w == 0.0 || blend <= 0.0 || blend >= 1.0) return straight;
    vec3 away = straight - ball.xyz;
    float radius = mix(distance(from, ball.xyz), distance(to, ball.xyz), blend);
    return ball.xyz + away * (radius / max(length(away), 1e-6 * ball.w));
}

void main() {
    vec4 to = row(physical, gl_VertexID);
    vec3 point = between(row(computational, gl_VertexID).xyz, to.xyz);
    gl_Position = clip * vec4(point, 1.0);
    outward = point - ball.xyz;
    value = to.w;
    pixel = gl_Position.xyz * clip_to_pixels;
}
