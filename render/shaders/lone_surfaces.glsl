// The layers of depth, in which what one view alone sees is kept where none of those that agree on
// something behind it looks past it: what depth_layers/lone_surfaces.h says in plain code.

#ifdef LUMI_FRAGMENT
#ifdef PACKED_LAYERS
// It was done when they were drawn.
vec4 kept_depths(ivec2 texel) { return layer_depths(texel); }
#else
// For each layer its view: three rows that give the homogeneous sample of its depth map from
// (x, y, 1, inverse depth) in texels, then (samples along x and y, layer of the depth map, unused).
uniform vec4 layer_samples[16];

bool looks_past(int layer, vec4 ray) {
    vec3 at = vec3(dot(layer_samples[4 * layer], ray), dot(layer_samples[4 * layer + 1], ray),
                   dot(layer_samples[4 * layer + 2], ray));
    vec3 size_and_map = layer_samples[4 * layer + 3].xyz;
    vec2 place = at.xy / max(at.z, 1e-20);
    bool is_inside = at.z > 0.0 && all(greaterThanEqual(place, vec2(0.0))) &&
                     all(lessThan(place, size_and_map.xy));
    if (!is_inside) return false;
    float seen = at.z * texelFetch(depth_maps, ivec3(ivec2(place), int(size_and_map.z)), 0).r;
    return ray.w - seen > max_inverse_depth / kKindWidth * agreeing_depth;
}

vec4 kept_depths(ivec2 texel) {
    vec4 depths = layer_depths(texel);
    float nearest = smallest(depths);
    bool is_alone = dot(agree(depths, nearest), vec4(1.0)) < 1.5;
    vec4 seen = mix(vec4(9.0), depths, lessThan(depths, vec4(kKindStep)));
    float first_agreed = smallest(seen + 9.0 * alone(depths));
    if (!is_alone || nearest >= kKindStep || first_agreed > 4.0) return depths;
    vec4 behind = agree(depths, first_agreed);
    vec4 ray = vec4(vec2(texel) + 0.5, 1.0, max_inverse_depth * (1.0 - nearest / kKindWidth));
    for (int layer = 0; layer < LAYERS; ++layer)
        if (behind[layer] > 0.5 && looks_past(layer, ray)) return depths;
    return mix(depths, vec4(1.0), behind);
}
#endif
#endif
