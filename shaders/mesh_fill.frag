#version 330 core
// The inside of cells: a colour map or one colour, softly lit by a lamp at the viewer: what faces the viewer
// has its colour, what turns away is darker.
#include "colour_map.glsl"
uniform vec4 surface;             // used where its alpha is above zero; then it is as opaque as that
uniform bool flat_cells;          // each cell has a value of its own
uniform bool nodal;               // as in mesh_fill.vert
uniform usampler2D shown_cells;   // which cell a triangle belongs to
uniform int first_triangle;       // of those that are drawn
uniform sampler2D cell_values;    // where a cell's value lies in the range
uniform bool round_cells;         // curved cells of a ball: `outward` is their normal
uniform vec3 viewer;              // towards the viewer, of unit length
uniform float dusk;               // how much of its colour a surface loses that is seen from its edge
uniform float pallor;             // of the skin of a solid that is cut: how pale and dark it is, 0 to 1

in float value; // linear in each half of a quadrilateral
in vec2 inside;
flat in vec3 bend;
flat in float far_half;
in vec3 pixel;
in vec3 outward;
out vec4 colour;

float own_value() {
    int triangle = first_triangle + gl_PrimitiveID;
    uint cell = texelFetch(shown_cells, ivec2(triangle & 2047, triangle >> 11), 0).r;
    return texelFetch(cell_values, ivec2(int(cell & 2047u), int(cell >> 11)), 0).r;
}

/// Bilinear in the quadrilateral: with bend_of() in mesh_fill.vert, q = s t solves q = (x - alpha q) (y -
/// beta q), where x and y are linear in the half.
float nodal_value() {
    vec2 at = far_half > 0.5 ? 1.0 - inside : inside;
    float product = at.x * at.y, b = 1.0 + bend.x * at.y + bend.y * at.x;
    float root = sqrt(max(b * b - 4.0 * bend.x * bend.y * product, 0.0));
    return value + bend.z * clamp(2.0 * product / max(b + root, 1e-3), 0.0, 1.0);
}

/// How much of its colour what is seen there keeps.
float light() {
    if (dusk == 0.0) return 1.0;
    vec3 normal = cross(dFdx(pixel), dFdy(pixel));
    float facing = round_cells ? dot(normalize(outward), viewer) : abs(normal.z) / max(length(normal), 1e-20);
    return 1.0 - dusk * pow(1.0 - clamp(facing, 0.0, 1.0), 1.6);
}

void main() {
    vec3 base = surface.rgb;
    if (surface.a == 0.0) {
        float place = value;
        if (flat_cells)
            place = own_value();
        else if (nodal)
            place = nodal_value();
        base = colour_of(place);
    }
    if (pallor > 0.0) {
        vec3 grey = vec3(dot(base, vec3(0.299, 0.587, 0.114)));
        base = mix(base, 0.78 * mix(base, grey, 0.55), pallor);
    }
    colour = vec4(base * light(), surface.a > 0.0 ? surface.a : 1.0);
}
