// The depth that several views agree on: each of the layers holds what one view's depth looks like
// to the eye (depth_layer.glsl).

#ifdef LUMI_FRAGMENT
uniform sampler2DArray depth_layers;
uniform float max_inverse_depth;
uniform float agreeing_depth;  // layers that differ by no more are of one surface
// For each layer its view: three rows that give its homogeneous pixel from (x, y, 1, inverse depth)
// in window coordinates, then (layer of the photograph, unused): -1 where there is none. Four rows
// for each of kMaxDepthViews (drawing_choices.h).
uniform vec4 layer_views[16];

// Where each kind of depth begins in the depth buffer, times the kind, and how far it goes; 1 is
// nothing. See depth_kind_ranges.h.
const float kKindStep = 0.33;
const float kKindWidth = 0.32;
// From here on in the depth buffer, which ends at 1, nothing is known.
const float kNothing = 0.995;
// Kinds are whole numbers, of which these lie above: what was seen; that or filled; all that is
// known.
const float kSeen = 0.5;
const float kSeenOrFilled = 1.5;
const float kKnown = 2.5;
// As if in the depth buffer: last of all in any order, and more than any that is not last.
const float kLast = 9.0;
const float kNotLast = 4.0;
// Where a view knows nothing: as far as can be from any inverse depth.
const float kNowhere = -1e9;

struct Depth {
    float inverse_depth;
    float kind;     // 0 seen, 1 filled, 2 stretched, 3 nothing known
    float support;  // how many views agree, at most 2
    int layer;      // the first of them
    bool is_behind_tears;  // whether all that agree see it behind what they stretch over a tear
    vec4 of_layers; // what each layer's view sees or fills in there
};

float smallest(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
vec4 agree(vec4 depths, float depth) {
    return vec4(lessThanEqual(abs(depths - depth), vec4(agreeing_depth)));
}

// PACKED_LAYERS: they lie in the components of one texel (depth_layers.h).
vec4 layer_depths(ivec2 texel) {
#ifdef PACKED_LAYERS
    return texelFetch(depth_layers, ivec3(texel, 0), 0);
#else
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
#endif
}

// 1 for layers that see it behind what they stretch over a tear (depth_layers/behind_tears.h).
vec4 behind_tears(vec4 depths) { return vec4(floatBitsToUint(depths) & 1u); }

// 1 for layers that no other agrees with.
vec4 alone(vec4 depths) {
    vec3 with_x = step(agreeing_depth, abs(depths.yzw - depths.x));
    vec3 others = step(agreeing_depth, abs(depths.yyz - depths.zww));
    return vec4(with_x.x * with_x.y * with_x.z, with_x.x * others.x * others.y,
                with_x.y * others.x * others.z, with_x.z * others.y * others.z);
}

// A view that stretches its surface over a tear does not see it.
vec4 seen_in_layers(vec4 depths) {
    vec4 kinds = step(kKindStep, depths) + step(2.0 * kKindStep, depths);
    vec4 inverse_depths = max_inverse_depth * (1.0 - (depths - kKindStep * kinds) / kKindWidth);
    return mix(inverse_depths, vec4(kNowhere), greaterThan(kinds, vec4(kSeenOrFilled)));
}

// The nearest depth that two views agree on, or else the nearest; only the most reliable kind
// counts, and of fills the farthest, because a fill continues the background. A surface that one
// view imagines before those that others see is thus left out.
//
// In the units of the depth buffer: kinds are kept so far apart there that none agrees with another
// (depth_layers.h). `behind`: as from behind_tears.
Depth agreed_depth(vec4 depths, vec4 behind) {
    float nearest = smallest(depths);
    float kind = step(kKindStep, nearest) + step(2.0 * kKindStep, nearest) + step(kNothing, nearest);
    float preferred = kind < kSeen ? 1.0 : -1.0;
    // Nothing of another kind is chosen.
    vec4 order =
        mix(vec4(kLast), preferred * depths, lessThan(depths, vec4(kKindStep * (kind + 1.0))));
    float first_agreed = smallest(order + kLast * alone(depths));
    bool has_agreed = first_agreed < kNotLast;
    float support = has_agreed ? 2.0 : 1.0;
    vec4 agreeing = agree(depths, preferred * (has_agreed ? first_agreed : smallest(order)));
    int layer = agreeing.x > 0.0 ? 0 : agreeing.y > 0.0 ? 1 : agreeing.z > 0.0 ? 2 : 3;
    float depth = dot(agreeing, depths) / dot(agreeing, vec4(1.0)) - kKindStep * kind;
    bool is_behind_tears = kind < kSeen && dot(agreeing, 1.0 - behind) < 0.5;
    return Depth(max_inverse_depth * max(0.0, 1.0 - depth / kKindWidth), kind, support, layer,
                 is_behind_tears, seen_in_layers(depths));
}

// The homogeneous pixel of (x, y, 1, inverse depth) in the layer's view. Linear in the ray: of
// (1, 0, 0, 0) it is the change along x.
vec3 pixel_in_layer(int layer, vec4 ray) {
    return vec3(dot(layer_views[4 * layer], ray), dot(layer_views[4 * layer + 1], ray),
                dot(layer_views[4 * layer + 2], ray));
}

float photograph_of_layer(int layer) { return layer_views[4 * layer + 3].x; }

// 1 for the layer that shows what the photograph's view knows, if any does.
vec4 layer_of_photograph(float photograph) {
    return vec4(equal(vec4(layer_views[3].x, layer_views[7].x, layer_views[11].x, layer_views[15].x),
                      vec4(photograph)));
}
#endif
