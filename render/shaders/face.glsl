// What both modes share: a face of the camera mesh as a polygon of the picture, and the three views
// that it is blended from. Everything that is affine in the pixel is interpolated by the rasteriser.

#ifdef LUMI_VERTEX
#define LUMI_VARYING out
#else
#define LUMI_VARYING in
#endif

// Side products of the ray with the face's edges; their ratios are the blending weights. In w the
// inverse depth of the scene plane.
LUMI_VARYING vec4 side_products_and_plane;
// Homogeneous pixel in view k at infinity; `view_parallaxk`.xyz is added for each unit of inverse
// depth, .w is the view's layer.
LUMI_VARYING vec3 view_pixel0;
LUMI_VARYING vec3 view_pixel1;
LUMI_VARYING vec3 view_pixel2;
flat LUMI_VARYING vec4 view_parallax0;
flat LUMI_VARYING vec4 view_parallax1;
flat LUMI_VARYING vec4 view_parallax2;
// Size of the photograph (xy), and samples of the depth map for each of its pixels (zw).
flat LUMI_VARYING vec4 view_size0;
flat LUMI_VARYING vec4 view_size1;
flat LUMI_VARYING vec4 view_size2;
// Pixels of disparity for each unit of inverse depth in the three views, and the face's index.
flat LUMI_VARYING vec4 disparity_and_face;

#ifdef FADES
// 1 for corners of the face beyond the border of the mesh.
flat LUMI_VARYING vec3 beyond_border;
#endif

#ifdef LUMI_VERTEX
uniform mat4 clip_from_eye_pixel;
layout(location = 0) in vec2 in_pixel;
layout(location = 1) in vec4 in_side_products_and_plane;
layout(location = 2) in vec3 in_view_pixel0;
layout(location = 3) in vec3 in_view_pixel1;
layout(location = 4) in vec3 in_view_pixel2;
layout(location = 5) in vec4 in_view_parallax0;
layout(location = 6) in vec4 in_view_parallax1;
layout(location = 7) in vec4 in_view_parallax2;
layout(location = 8) in vec4 in_view_size0;
layout(location = 9) in vec4 in_view_size1;
layout(location = 10) in vec4 in_view_size2;
layout(location = 11) in vec4 in_disparity_and_face;
layout(location = 12) in vec3 in_beyond_border;

void main() {
    side_products_and_plane = in_side_products_and_plane;
    view_pixel0 = in_view_pixel0;
    view_pixel1 = in_view_pixel1;
    view_pixel2 = in_view_pixel2;
    view_parallax0 = in_view_parallax0;
    view_parallax1 = in_view_parallax1;
    view_parallax2 = in_view_parallax2;
    view_size0 = in_view_size0;
    view_size1 = in_view_size1;
    view_size2 = in_view_size2;
    disparity_and_face = in_disparity_and_face;
#ifdef FADES
    beyond_border = in_beyond_border;
#endif
    gl_Position = clip_from_eye_pixel * vec4(in_pixel, 1.0, 0.5);
}
#endif

#ifdef LUMI_FRAGMENT
uniform vec2 photograph_layers_per_pixel;  // 1 / size of a layer

vec4 photograph_at_pixel(vec2 pixel, float layer) {
    return photograph_at((pixel + kGutter_px) * photograph_layers_per_pixel, layer);
}

vec3 blending_weights() {
    vec3 weights = max(side_products_and_plane.xyz, 0.0);
    // At the tip of a polygon that reaches a little beyond its face all may be 0.
    return weights / max(weights.x + weights.y + weights.z, 1e-20);
}

vec4 layers_and_face() {
    return vec4(view_parallax0.w, view_parallax1.w, view_parallax2.w, disparity_and_face.w);
}

#ifdef FADES
uniform float is_shell;     // 1 or 0
uniform float faded_share;  // see camera_mesh.h

// How far inside of a photograph the point lies: 1 from a tenth of the shorter side on.
float inner(vec2 pixel, vec2 size) {
    vec2 to_border = min(pixel, size - pixel);
    return clamp(10.0 * min(to_border.x, to_border.y) / min(size.x, size.y), 0.0, 1.0);
}

// What is seen beyond the border fades out. A shell (CameraMesh::shells) is also drawn only as far
// as its views see the point, away from the borders of their photographs. The same as
// shell_opacity in render/faces/shell_opacity.h.
float opacity_of(vec3 ray_weights, vec3 inside, float seen, float is_known) {
    float fade = 1.0 - smoothstep(0.0, faded_share, dot(ray_weights, beyond_border));
    float refined = is_known * smoothstep(0.0, 0.5, seen) * dot(ray_weights, inside);
    return fade * mix(1.0, refined, is_shell);
}
#endif
#endif
