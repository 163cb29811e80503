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
#ifdef MARKS_BEHIND_TEARS
// What the view has seen, marked by its last bit where it lies behind what the view stretches over a
// tear: see depth_layers/behind_tears.h.
uniform sampler2DArray stretched;
uniform float agreeing_depth;

const float kStretchedBegins = 0.66;  // in the depth buffer: twice kKindStep of agreed_depth.glsl

void main() {
    float nearest = texelFetch(stretched, ivec3(gl_FragCoord.xy, 0), 0).r - kStretchedBegins;
    uint is_behind = nearest + agreeing_depth < gl_FragCoord.z ? 1u : 0u;
    gl_FragDepth = uintBitsToFloat((floatBitsToUint(gl_FragCoord.z) & ~1u) | is_behind);
}
#else
void main() {}
#endif
#endif
