// The colour map; a place in it is 0 to 1 along the range of values.
uniform sampler2D colours;
uniform float logarithm; // of the range's high end over its low one; 0: the range is linear

vec3 colour_of(float place) {
    float t = place;
    if (logarithm > 0.0) t = log(1.0 + max(place, 0.0) * (exp(logarithm) - 1.0)) / logarithm;
    float last = float(textureSize(colours, 0).x) - 1.0;
    return texture(colours, vec2((clamp(t, 0.0, 1.0) * last + 0.5) / (last + 1.0), 0.5)).rgb;
}
