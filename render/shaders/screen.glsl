// The vertices of a program that fills the viewport (gl/screen.h).

#ifdef LUMI_VERTEX
layout(location = 0) in vec2 in_position;
out vec2 position;  // 0 to 1 over the viewport

void main() {
    position = in_position;
    gl_Position = vec4(2.0 * in_position - 1.0, 0.0, 1.0);
}
#endif
