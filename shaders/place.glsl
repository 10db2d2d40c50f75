// Where a shown point stands on its way from xi to x. Points are fetched by number from tables that are 2048
// texels wide.
uniform sampler2D computational; // xi relative to the picture's centre
uniform sampler2D physical;      // x likewise; w: where the value lies in the range of colours, 0 to 1
uniform float blend;
uniform vec4 ball; // centre and radius of the sphere that the nodes lie on; radius 0: they lie on none

vec4 row(sampler2D table, int i) { return texelFetch(table, ivec2(i & 2047, i >> 11), 0); }

/// Half way is on the ball too.
vec3 between(vec3 from, vec3 to) {
    vec3 straight = mix(from, to, blend);
    if (ball.w == 0.0 || blend <= 0.0 || blend >= 1.0) return straight;
    vec3 away = straight - ball.xyz;
    float radius = mix(distance(from, ball.xyz), distance(to, ball.xyz), blend);
    return ball.xyz + away * (radius / max(length(away), 1e-6 * ball.w));
}
