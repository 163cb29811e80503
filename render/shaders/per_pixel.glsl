// Depth, weights and visibility at each pixel.
//
// The depth is what the layers, one a view, agree on. The point there is looked up in the three
// views of the face; those that do not see it lose their weight to the others (the paper, section
// 4, occlusion correction). When none sees it, the view that the depth came from does.

#ifdef LUMI_FRAGMENT
uniform sampler2DArray depth_maps;
uniform sampler2DArray depth_layers;
uniform vec2 viewport_origin;
uniform float max_inverse_depth;
uniform float agreeing_inverse_depth;    // depths that differ by no more are of one surface
uniform float tolerance_px;
uniform int correct_occlusion;
// For each layer its view: three rows that give its homogeneous pixel from (x, y, 1, inverse depth)
// in window coordinates, then (layer of the photograph, its width, its height, weight of the depth).
uniform vec4 layer_views[4 * LAYERS];

// Kinds of depth are kept apart in ranges of the depth buffer; see depth_layers.h.
const float kKindBegin[4] = float[4](0.0, 0.5, 0.75, 0.995);
const float kKindScale[3] = float[3](1.0 / 0.49, 1.0 / 0.24, 1.0 / 0.24);

int kind_of(float depth) {
    return depth < kKindBegin[1] ? 0 : depth < kKindBegin[2] ? 1 : depth < kKindBegin[3] ? 2 : 3;
}

struct Depth {
    float inverse_depth;
    int kind;     // 0 seen, 1 filled, 2 stretched, 3 nothing known
    int layer;    // the best view among those that agree
    int support;  // how many agree
};

bool agree(float a, float b) { return abs(a - b) <= agreeing_inverse_depth; }

// The nearest depth that two views agree on, or else the nearest; only the most reliable kind
// counts. A surface that one view imagines before those that others see is thus left out.
Depth consensus(ivec2 pixel) {
    float depths[LAYERS];
    Depth chosen = Depth(-1.0, 3, 0, 0);
    for (int l = 0; l < LAYERS; ++l) {
        depths[l] = texelFetch(depth_layers, ivec3(pixel, l), 0).r;
        chosen.kind = min(chosen.kind, kind_of(depths[l]));
    }
    if (chosen.kind == 3) return chosen;
    for (int l = 0; l < LAYERS; ++l) {
        float range = (depths[l] - kKindBegin[chosen.kind]) * kKindScale[chosen.kind];
        // Nothing agrees with what is of another kind.
        depths[l] = kind_of(depths[l]) == chosen.kind ? max_inverse_depth * (1.0 - range)
                                                      : -1e20 * float(l + 1);
    }
    for (int l = 0; l < LAYERS; ++l) {
        if (depths[l] < -1.0) continue;
        int support = 0;
        for (int other = 0; other < LAYERS; ++other)
            if (agree(depths[l], depths[other])) ++support;
        support = min(support, 2);
        if (support > chosen.support ||
            (support == chosen.support && depths[l] > chosen.inverse_depth))
            chosen = Depth(depths[l], chosen.kind, l, support);
    }
    float sum = 0.0;
    float weight = 0.0;
    for (int l = LAYERS - 1; l >= 0; --l) {
        if (!agree(depths[l], chosen.inverse_depth)) continue;
        sum += layer_views[4 * l + 3].w * depths[l];
        weight += layer_views[4 * l + 3].w;
        chosen.layer = l;
    }
    chosen.inverse_depth = max(0.0, sum / weight);
    return chosen;
}

float view_depth(vec2 pixel, vec4 size, float layer) {
    vec2 on_layer = clamp(pixel * size.zw / size.xy, vec2(0.5), size.zw - 0.5);
#ifdef LINEAR_DEPTH
    vec2 layer_size = vec2(textureSize(depth_maps, 0).xy);
    return textureLod(depth_maps, vec3(on_layer / layer_size, layer), 0.0).r;
#else
    vec2 corner = floor(on_layer - 0.5);
    vec2 share = on_layer - 0.5 - corner;
    ivec2 low = ivec2(corner);
    ivec2 high = min(low + 1, ivec2(size.zw) - 1);
    int l = int(layer);
    return mix(mix(texelFetch(depth_maps, ivec3(low.x, low.y, l), 0).r,
                   texelFetch(depth_maps, ivec3(high.x, low.y, l), 0).r, share.x),
               mix(texelFetch(depth_maps, ivec3(low.x, high.y, l), 0).r,
                   texelFetch(depth_maps, ivec3(high.x, high.y, l), 0).r, share.x),
               share.y);
#endif
}

// 1 when the view sees the point at `pixel`, 0 when it sees something else; in between a ramp.
float visibility(vec3 pixel, vec4 size, float layer, Depth depth, float disparity_px) {
    float inside = feather(pixel, size.xy);
    if (correct_occlusion == 0 || depth.kind == 3 || inside == 0.0) return inside;
    float seen = view_depth(pixel.xy / pixel.z, size, layer);
    float difference_px = abs(depth.inverse_depth / pixel.z - seen) * disparity_px;
    return inside * clamp(2.0 - difference_px / tolerance_px, 0.0, 1.0);
}

// Two views agree: 1; one has seen it: 0.5; filled: 0.25; stretched: 0.125; a guess: 0.
float confidence_of(Depth depth) {
    if (depth.kind == 0) return 0.5 * float(depth.support);
    return depth.kind == 1 ? 0.25 : depth.kind == 2 ? 0.125 : 0.0;
}

vec3 color_of_layer(Depth depth, vec2 window) {
    vec4 ray = vec4(window, 1.0, depth.inverse_depth);
    vec3 in_view = vec3(dot(layer_views[4 * depth.layer], ray),
                        dot(layer_views[4 * depth.layer + 1], ray),
                        dot(layer_views[4 * depth.layer + 2], ray));
    vec4 view = layer_views[4 * depth.layer + 3];
    return photograph(in_view, view.yz, view.x);
}

void main() {
    vec2 window = gl_FragCoord.xy - viewport_origin;
    Depth depth = consensus(ivec2(window));
    // Where no depth is known the scene plane is a guess: drawn, but not counted as covered.
    float known = depth.kind == 3 ? 0.0 : 1.0;
    if (depth.kind == 3) depth.inverse_depth = max(0.0, side_products_and_plane.w);
    float q = depth.inverse_depth;
    vec3 pixel0 = view_pixel0 + q * view_parallax0.xyz;
    vec3 pixel1 = view_pixel1 + q * view_parallax1.xyz;
    vec3 pixel2 = view_pixel2 + q * view_parallax2.xyz;
    vec3 weights =
        blending_weights() *
        vec3(visibility(pixel0, view_size0, view_parallax0.w, depth, disparity_and_face.x),
             visibility(pixel1, view_size1, view_parallax1.w, depth, disparity_and_face.y),
             visibility(pixel2, view_size2, view_parallax2.w, depth, disparity_and_face.z));
    float sum = weights.x + weights.y + weights.z;
    bool unseen = sum < 1e-4;
    if (unseen && depth.kind == 3) discard;
    weights /= max(sum, 1e-4);
#ifdef DEBUG_PICTURE
    // White: none of the three sees the point.
    bool marked = unseen && debug_picture == 1;
    drawn = vec4(marked ? vec3(1.0)
                        : debug_color(weights, layers_and_face(), q, confidence_of(depth)),
                 known);
#else
    drawn = vec4(weights.x * photograph(pixel0, view_size0.xy, view_parallax0.w) +
                     weights.y * photograph(pixel1, view_size1.xy, view_parallax1.w) +
                     weights.z * photograph(pixel2, view_size2.xy, view_parallax2.w),
                 known);
    if (unseen) drawn.rgb = color_of_layer(depth, window);
#endif
}
#endif
