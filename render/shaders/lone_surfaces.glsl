// The layers of depth, in which it is settled whether what one view alone sees before all others is
// there or imagined: what depth_layers/lone_surfaces.h says in plain code.

#ifdef LUMI_FRAGMENT
#ifdef PACKED_LAYERS
// It was done when they were drawn.
vec4 settled_depths(ivec2 texel) { return layer_depths(texel); }
#else
// For each layer its view: three rows that give the homogeneous sample of its depth map from
// (x, y, 1, inverse depth) in texels, then (samples along x and y, layer of the depth map, unused).
uniform vec4 layer_samples[16];

#define kAgreeing (max_inverse_depth / kKindWidth * agreeing_depth)
const float kAnywhere = 1e30;
const int kNotPast = 0;
const int kPerhapsPast = 1;
const int kSurelyPast = 2;

// As PastSight (past_sight.h). The last bit of a sample tells whether several views agree on it
// (uploaded_lumigraph.cpp).
int past(int layer, vec4 ray, float nearest_seen) {
    vec3 at = vec3(dot(layer_samples[4 * layer], ray), dot(layer_samples[4 * layer + 1], ray),
                   dot(layer_samples[4 * layer + 2], ray));
    vec3 size_and_map = layer_samples[4 * layer + 3].xyz;
    vec2 place = at.xy / max(at.z, 1e-20);
    bool is_inside = at.z > 0.0 && all(greaterThanEqual(place, vec2(0.0))) &&
                     all(lessThan(place, size_and_map.xy));
    if (!is_inside) return kNotPast;
    float seen = texelFetch(depth_maps, ivec3(ivec2(place), int(size_and_map.z)), 0).r;
    if (ray.w - at.z * seen <= kAgreeing || at.z * seen > nearest_seen) return kNotPast;
    return (floatBitsToUint(seen) & 1u) != 0u ? kSurelyPast : kPerhapsPast;
}

// Whether the view of any of these layers looks past the ray's point, so surely at least.
bool is_any_past(vec4 layers, vec4 ray, int least, float nearest_seen) {
    for (int layer = 0; layer < LAYERS; ++layer)
        if (layers[layer] > 0.5 && past(layer, ray, nearest_seen) >= least) return true;
    return false;
}

vec4 settled_depths(ivec2 texel) {
    vec4 depths = layer_depths(texel);
    for (int number = 0; number < LAYERS; ++number) {
        float nearest = smallest(depths);
        vec4 at_nearest = agree(depths, nearest);
        bool is_alone = dot(at_nearest, vec4(1.0)) < 1.5;
        if (nearest >= kKindStep || !is_alone) return depths;
        vec4 is_seen = vec4(lessThan(depths, vec4(kKindStep)));
        float first_agreed = smallest(mix(vec4(kLast), depths, is_seen) + kLast * alone(depths));
        vec4 ray = vec4(vec2(texel) + 0.5, 1.0, max_inverse_depth * (1.0 - nearest / kKindWidth));
        if (first_agreed < kNotLast) {
            vec4 behind = agree(depths, first_agreed);
            float agreed = max_inverse_depth * (1.0 - first_agreed / kKindWidth);
            float nearest_seen = agreed <= kAgreeing ? kAgreeing : kAnywhere;
            return is_any_past(behind, ray, kPerhapsPast, nearest_seen)
                       ? depths
                       : mix(depths, vec4(1.0), behind);
        }
        if (!is_any_past(is_seen * (1.0 - at_nearest), ray, kSurelyPast, kAnywhere))
            return depths;
        depths = mix(depths, vec4(1.0), at_nearest);
    }
    return depths;
}
#endif
#endif
