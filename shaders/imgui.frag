#version 330 core
uniform sampler2D image;

in vec2 texel_here;
in vec4 tint_here;
out vec4 colour;

void main() { colour = tint_here * texture(image, texel_here); }
