// Colours at the corners of a grid: what lies beyond the capture, guessed; not covered.

#ifdef LUMI_VERTEX
uniform mat4 clip_from_eye_pixel;
layout(location = 0) in vec2 in_pixel;
layout(location = 1) in vec3 in_color;
out vec3 color;

void main() {
    color = in_color / 255.0;
    gl_Position = clip_from_eye_pixel * vec4(in_pixel, 1.0, 0.5);
}
#endif

#ifdef LUMI_FRAGMENT
in vec3 color;

void main() {
#ifdef BLOCKS
    vec3 to_right = 0.25 * dFdx(color);  // half a pixel of the block's two
    vec3 to_above = 0.25 * dFdy(color);
    drawn = vec4(color - to_right - to_above, 0.0);
    drawn_right = vec4(color + to_right - to_above, 0.0);
    drawn_above = vec4(color - to_right + to_above, 0.0);
    drawn_above_right = vec4(color + to_right + to_above, 0.0);
#else
    drawn = vec4(color, 0.0);
#endif
}
#endif
