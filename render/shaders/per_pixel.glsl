// Depth, weights and visibility at each pixel.
//
// The depth is what the layers, one a view, agree on. The point there is looked up in the three
// views of the face; those that do not see it lose their weight to the others (the paper, section
// 4, occlusion correction). When none sees it, the view that the depth came from does.
//
// Written for software rendering: no arrays, no loops, no branches, one division a view.

#ifdef LUMI_FRAGMENT
uniform sampler2DArray depth_maps;
uniform sampler2DArray depth_layers;
uniform vec2 viewport_origin;
uniform float max_inverse_depth;
uniform float near_inverse_depth;        // the scene's near end
uniform float agreeing_depth;            // layers that differ by no more are of one surface
uniform float texels_per_pixel;          // of the layers; see depth_eye.h
uniform float texels_below;              // the picture, where it ends within a texel
uniform float check_per_px;              // 1 / tolerance; 0 without occlusion correction
uniform vec4 strip_ends;                 // of each set of views: see depth_view_choice.h
// For each layer of each set its view: three rows that give its homogeneous pixel from (x, y, 1,
// inverse depth) in window coordinates, then (layer of the photograph, its width, its height,
// unused).
uniform vec4 layer_views[64];

// Photographs that count less than this, of their weights, hold mixed pixels alone: see
// photograph_opacity.h.
const float kLeastCounting = 0.25;
const float kMostParallax_px = 1.0;

// Where each kind of depth begins in the depth buffer, times the kind, and how far it goes; 1 is
// nothing. See depth_layers.h.
const float kKindStep = 0.33;
const float kKindWidth = 0.32;

struct Depth {
    float inverse_depth;
    float kind;     // 0 seen, 1 filled, 2 stretched, 3 nothing known
    float support;  // how many views agree, at most 2
    int layer;      // the first of them
};

float smallest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
vec4 agree(vec4 depths, float depth) {
    return vec4(lessThanEqual(abs(depths - depth), vec4(agreeing_depth)));
}

vec4 layer_depths(ivec2 texel) {
    vec4 depths = vec4(1.0);
    depths.x = texelFetch(depth_layers, ivec3(texel, 0), 0).r;
#if LAYERS > 1
    depths.y = texelFetch(depth_layers, ivec3(texel, 1), 0).r;
#endif
#if LAYERS > 2
    depths.z = texelFetch(depth_layers, ivec3(texel, 2), 0).r;
#endif
#if LAYERS > 3
    depths.w = texelFetch(depth_layers, ivec3(texel, 3), 0).r;
#endif
    return depths;
}

// 1 for layers that no other agrees with.
vec4 alone(vec4 depths) {
    vec3 with_x = step(agreeing_depth, abs(depths.yzw - depths.x));
    vec3 others = step(agreeing_depth, abs(depths.yyz - depths.zww));
    return vec4(with_x.x * with_x.y * with_x.z, with_x.x * others.x * others.y,
                with_x.y * others.x * others.z, with_x.z * others.y * others.z);
}

// The nearest depth that two views agree on, or else the nearest; only the most reliable kind
// counts, and of fills the farthest, because a fill continues the background. A surface that one
// view imagines before those that others see is thus left out.
//
// In the units of the depth buffer: kinds are kept so far apart there that none agrees with another
// (depth_layers.h).
Depth consensus(ivec2 texel) {
    vec4 depths = layer_depths(texel);
    float nearest = smallest(depths);
    float kind = step(kKindStep, nearest) + step(2.0 * kKindStep, nearest) + step(0.995, nearest);
    float preferred = kind < 0.5 ? 1.0 : -1.0;
    // Nothing of another kind is chosen.
    vec4 order = mix(vec4(9.0), preferred * depths, lessThan(depths, vec4(kKindStep * (kind + 1.0))));
    float first_agreed = smallest(order + 9.0 * alone(depths));
    float support = first_agreed < 4.0 ? 2.0 : 1.0;
    vec4 agreeing = agree(depths, preferred * (support > 1.5 ? first_agreed : smallest(order)));
    int layer = agreeing.x > 0.0 ? 0 : agreeing.y > 0.0 ? 1 : agreeing.z > 0.0 ? 2 : 3;
    float depth = dot(agreeing, depths) / dot(agreeing, vec4(1.0)) - kKindStep * kind;
    return Depth(max_inverse_depth * max(0.0, 1.0 - depth / kKindWidth), kind, support, layer);
}

// A view at a point: xy its pixel, z the inverse of its homogeneous coordinate.
vec3 sight_of(vec3 pixel) {
    float inverse = 1.0 / max(pixel.z, 1e-20);
    return vec3(pixel.xy * inverse, inverse);
}

// 1 when the view sees the point, 0 when it sees something else; in between a ramp. `size` is that
// of the photograph, and samples of the depth map for each of its pixels.
float visibility(vec3 sight, float is_before, vec4 size, float layer, float inverse_depth,
                 float disparity_px, float check) {
    vec2 to_border = min(sight.xy, size.xy - sight.xy);
    float inside = step(0.0, min(to_border.x, to_border.y)) * is_before;
    // What lies outside has no sample, and no say.
    float seen = texelFetch(depth_maps, ivec3(ivec2(sight.xy * size.zw), int(layer)), 0).r;
    float difference_px = abs(inverse_depth * sight.z - seen) * disparity_px;
    return inside * clamp(2.0 - check * difference_px, 0.0, 1.0);
}

void main() {
    vec2 window = gl_FragCoord.xy - viewport_origin;
    ivec2 texel = ivec2(window * texels_per_pixel + vec2(0.0, texels_below));
    Depth depth = consensus(texel);
    // Where no depth is known the scene plane is a guess: drawn, but not counted as covered.
    bool is_guess = depth.kind > 2.5;
    float q = is_guess ? max(0.0, side_products_and_plane.w) : depth.inverse_depth;
    vec3 pixel0 = AT_CENTRE(view_pixel0) + q * view_parallax0.xyz;
    vec3 pixel1 = AT_CENTRE(view_pixel1) + q * view_parallax1.xyz;
    vec3 pixel2 = AT_CENTRE(view_pixel2) + q * view_parallax2.xyz;
    vec3 sight0 = sight_of(pixel0);
    vec3 sight1 = sight_of(pixel1);
    vec3 sight2 = sight_of(pixel2);
    vec3 is_before = vec3(greaterThan(vec3(pixel0.z, pixel1.z, pixel2.z), vec3(0.0)));
    float check = is_guess ? 0.0 : check_per_px;
    vec3 weights = max(side_products_and_plane.xyz, 0.0);
    weights *= 1.0 / (weights.x + weights.y + weights.z);
#ifdef FADES
    vec3 ray_weights = weights;
#endif
    weights *= vec3(visibility(sight0, is_before.x, view_size0, view_parallax0.w, q,
                               disparity_and_face.x, check),
                    visibility(sight1, is_before.y, view_size1, view_parallax1.w, q,
                               disparity_and_face.y, check),
                    visibility(sight2, is_before.z, view_size2, view_parallax2.w, q,
                               disparity_and_face.z, check));
    float sum = weights.x + weights.y + weights.z;
    bool unseen = sum < 1e-4;
#ifdef DEBUG_PICTURE
    float occluded = unseen ? 1.0 : 1.0 - sum;
#endif
    if (unseen && is_guess) discard;
    // What none of the three sees and no view has seen is drawn as a guess too.
    float is_known = is_guess || (unseen && depth.kind > 1.5) ? 0.0 : 1.0;
    // Unseen by the three: the layer's view takes the first one's place.
    int set = int(dot(vec4(greaterThanEqual(vec4(texel.x), strip_ends)), vec4(1.0)));
    int view = 16 * set + 4 * depth.layer;
    vec4 ray = vec4(window, 1.0, q);
    vec3 in_layer = sight_of(vec3(dot(layer_views[view], ray),
                                  dot(layer_views[view + 1], ray),
                                  dot(layer_views[view + 2], ray)));
    vec4 color0 = photograph_at_pixel(
        unseen ? in_layer.xy : sight0.xy,
        unseen ? layer_views[view + 3].x : view_parallax0.w);
    vec4 color1 = photograph_at_pixel(sight1.xy, view_parallax1.w);
    vec4 color2 = photograph_at_pixel(sight2.xy, view_parallax2.w);
    vec3 seen_weights = weights;
    weights *= vec3(color0.a, color1.a, color2.a);
    float counting = weights.x + weights.y + weights.z;
    // Where all are mixed of two surfaces the colour is a guess, unless a camera is where the eye is.
    float pure = counting + dot(seen_weights, step(near_inverse_depth * disparity_and_face.xyz,
                                                   vec3(kMostParallax_px)));
    float covered = is_known * (unseen ? 1.0 : step(kLeastCounting * sum, pure));
#ifdef FADES
    float seen = unseen ? 0.0 : counting;
    // A shell is laid over by its alpha: it hides what is beneath.
    covered = mix(covered, is_known, is_shell);
#endif
    weights = unseen ? vec3(1.0, 0.0, 0.0) : weights * (1.0 / max(counting, 1e-9));
#ifdef DEBUG_PICTURE
    // Two views agree: 1; one has seen it: 0.5; filled: 0.25; stretched: 0.125; a guess: 0.
    float confidence = depth.kind < 0.5   ? 0.5 * depth.support
                       : depth.kind < 1.5 ? 0.25
                       : is_guess         ? 0.0
                                          : 0.125;
    // White: none of the three sees the point.
    bool marked = unseen && debug_picture == 1;
    drawn = vec4(marked ? vec3(1.0) : debug_color(weights, layers_and_face(), q, confidence, occluded),
                 covered);
#else
    drawn = vec4(weights.x * color0.rgb + weights.y * color1.rgb + weights.z * color2.rgb,
                 covered);
#endif
#ifdef FADES
    vec3 inside = vec3(inner(sight0.xy, view_size0.xy), inner(sight1.xy, view_size1.xy),
                       inner(sight2.xy, view_size2.xy));
    drawn *= opacity_of(ray_weights, inside, seen, is_known);
#endif
}
#endif
