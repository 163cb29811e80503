// Edges of triangles over the picture.

#ifdef LUMI_VERTEX
uniform mat4 clip_from_eye_pixel;
layout(location = 0) in vec2 in_pixel;

void main() { gl_Position = clip_from_eye_pixel * vec4(in_pixel, 1.0, 0.5); }
#endif

#ifdef LUMI_FRAGMENT
out vec4 drawn;

// Whole levels of 255, as halves are rounded either way.
void main() { drawn = vec4(255.0, 230.0, 26.0, 255.0) / 255.0; }
#endif
