// The depth of one view's mesh as the eye sees it; no colour.

#ifdef LUMI_VERTEX
uniform mat4 clip_from_view_pixel;
layout(location = 0) in vec3 pixel_and_inverse_depth;

void main() {
    gl_Position =
        clip_from_view_pixel * vec4(pixel_and_inverse_depth.xy, 1.0, pixel_and_inverse_depth.z);
}
#endif

#ifdef LUMI_FRAGMENT
void main() {}
#endif
