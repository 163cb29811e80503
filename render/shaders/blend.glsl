// Triangles on which photographs are blended with weights from the corners: what the modes come to
// that do their work at vertices. Little more than the least that any blend must do. LOOKUPS is how
// many photographs are looked up, one to three; the others have no weight.

#ifdef LUMI_VERTEX
#define LUMI_VARYING out
#else
#define LUMI_VARYING in
#endif

LUMI_VARYING vec4 on_layers01;  // where photographs 0 and 1 are looked up, 0 to 1 over a layer
LUMI_VARYING vec4 on_layer2_and_weights;  // the same for photograph 2, weights of 0 and 1
flat LUMI_VARYING vec4 layers_and_face;
LUMI_VARYING vec4 weight2_and_depth;  // weight of 2, inverse depth, confidence, occlusion
#ifdef FADES
LUMI_VARYING float opacity;
#endif
#ifdef FILLS
LUMI_VARYING vec3 surroundings;  // what is drawn where no photograph shows anything
#endif

#ifdef LUMI_VERTEX
void main() {
    on_layers01 = (in_view_pixels01 + kGutter_px) / layer_size.xyxy;
    on_layer2_and_weights = vec4((in_view_pixel2 + kGutter_px) / layer_size, in_weights.xy);
    weight2_and_depth = vec4(in_weights.z, in_inverse_depth_and_confidence);
    layers_and_face = in_layers_and_face;
#ifdef FADES
    opacity = in_opacity_and_surroundings.x;
#endif
#ifdef FILLS
    surroundings = in_opacity_and_surroundings.yzw / 255.0;
#endif
    vec3 pixel = vec3(in_pixel_and_depth.xy, 1.0) * in_pixel_and_depth.z;
    gl_Position = clip_from_eye_pixel * vec4(pixel, 0.5 * pixel.z);
}
#endif

#ifdef LUMI_FRAGMENT
out vec4 drawn;
uniform float least_confidence;  // what is less sure is a guess: drawn, but not counted as covered
#ifdef FADES
uniform float is_laid_over;  // 1 where a picture is behind, 0 where nothing is
#endif

void main() {
    vec2 place0 = PLACE_AT_CENTRE(on_layers01.xy);
    vec2 place1 = PLACE_AT_CENTRE(on_layers01.zw);
    vec2 place2 = PLACE_AT_CENTRE(on_layer2_and_weights.xy);
    vec3 weights = vec3(on_layer2_and_weights.zw, weight2_and_depth.x);
    vec4 color0 = photograph_at(place0, layers_and_face.x);
    weights.x *= color0.a;
#if LOOKUPS >= 2
    vec4 color1 = photograph_at(place1, layers_and_face.y);
    weights.y *= color1.a;
#endif
#if LOOKUPS == 3
    vec4 color2 = photograph_at(place2, layers_and_face.z);
    weights.z *= color2.a;
#endif
#if LOOKUPS == 1
    float sum = weights.x;
#elif LOOKUPS == 2
    float sum = weights.x + weights.y;
#else
    float sum = weights.x + weights.y + weights.z;
#endif
    // What nobody sees shows what is behind, or its surroundings. Only where that may be: to discard
    // costs every pixel.
#ifdef DISCARDS
    if (sum < kLeastWeight) discard;
#endif
    float is_seen = step(kLeastWeight, sum);
    weights *= is_seen / max(sum, kLeastWeight);
    float is_known = is_seen * step(least_confidence, weight2_and_depth.z);
#ifdef KNOWN_ALONE
    if (is_known == 0.0) discard;
#endif
#ifdef DEBUG_PICTURE
    drawn = vec4(is_seen * debug_color(weights, layers_and_face, weight2_and_depth.y,
                                       weight2_and_depth.z, weight2_and_depth.w),
                 is_known);
#ifdef KNOWN_ALONE
    // White, as in per_pixel.glsl: none of those that should see it does.
    if (debug_picture == SHOW_WEIGHTS) drawn.rgb = vec3(1.0);
#endif
#elif LOOKUPS == 1
    drawn = vec4(is_seen * color0.rgb, is_known);
#elif LOOKUPS == 2
    drawn = vec4(weights.x * color0.rgb + weights.y * color1.rgb, is_known);
#else
    drawn = vec4(weights.x * color0.rgb + weights.y * color1.rgb + weights.z * color2.rgb,
                 is_known);
#endif
#ifdef FADES
    // What is laid over a picture hides it by its alpha, a guess too.
    drawn.a = mix(drawn.a, is_seen, is_laid_over);
    drawn *= opacity;
#endif
#ifdef FILLS
    drawn.rgb += (1.0 - is_seen) * surroundings;
#endif
}
#endif
