// One of the paper's three passes over depth-corrected triangles (section 4): a projective texture,
// its weight as alpha, added up by the framebuffer.

#ifdef LUMI_VERTEX
#define LUMI_VARYING out
#else
#define LUMI_VARYING in
#endif

LUMI_VARYING vec3 on_layer;  // homogeneous
LUMI_VARYING float weight;
flat LUMI_VARYING vec4 layers_and_face;
LUMI_VARYING vec3 inverse_depth_and_confidence;
flat LUMI_VARYING float layer;

#ifdef LUMI_VERTEX
uniform vec3 chosen;  // 1 for the view of this pass, 0 for the others

void main() {
    // Chosen, not summed: where a corner lies behind another view, it has no place there.
    vec2 view_pixel = chosen.x > 0.5   ? in_view_pixels01.xy
                      : chosen.y > 0.5 ? in_view_pixels01.zw
                                       : in_view_pixel2;
    float ratio = dot(chosen, in_depth_ratios);
    // Vertices at their true places: what is linear in space is interpolated linearly there.
    float depth = in_pixel_and_depth.z;
    on_layer = ratio > 0.0 ? vec3((view_pixel + kGutter_px) / layer_size, 1.0) * ratio * depth
                           : vec3(0.0);
    weight = dot(chosen, in_weights);
    layer = dot(chosen, in_layers_and_face.xyz);
    layers_and_face = in_layers_and_face;
    inverse_depth_and_confidence = in_inverse_depth_and_confidence;
    gl_Position = clip_from_eye_pixel * vec4(in_pixel_and_depth.xy * depth, depth, 0.5 * depth);
}
#endif

#ifdef LUMI_FRAGMENT
out vec4 drawn;

void main() {
#ifdef DEBUG_PICTURE
    // In debug pictures the three passes add up as the photographs do.
    drawn = vec4(debug_picture == SHOW_WEIGHTS ? index_color(layer)
                                    : debug_color(vec3(0.0), layers_and_face,
                                                  inverse_depth_and_confidence.x,
                                                  inverse_depth_and_confidence.y,
                                                  inverse_depth_and_confidence.z),
                 weight);
#else
    vec2 place = on_layer.xy / max(on_layer.z, 1e-20);
    drawn = vec4(photograph_at(PLACE_AT_CENTRE(place), layer).rgb, weight);
#endif
}
#endif
