// Colours of the photographs, and the colours of debug pictures: what all programs share.

#ifdef LUMI_FRAGMENT
uniform sampler2DArray photographs;

// A colour of a layer, whose coordinates run from 0 to 1; encoded sRGB, blended as such.
vec3 photograph_at(vec2 on_layer, float layer) {
    return textureLod(photographs, vec3(on_layer, layer), 0.0).rgb;
}

#ifdef DEBUG_PICTURE
uniform int debug_picture;         // DebugPicture in frame.h
uniform vec2 inverse_depth_range;  // far, near: black and white in the depth picture

// A colour for an index; neighbours differ (golden ratio).
vec3 index_color(float index) {
    return 0.5 + 0.5 * cos(6.2831853 * (fract(0.618034 * index) + vec3(0.0, 0.3333333, 0.6666667)));
}

vec3 debug_color(vec3 weights, vec4 layers_and_face, float inverse_depth, float confidence) {
    if (debug_picture == 1)
        return weights.x * index_color(layers_and_face.x) +
               weights.y * index_color(layers_and_face.y) +
               weights.z * index_color(layers_and_face.z);
    if (debug_picture == 2) return index_color(layers_and_face.w);
    if (debug_picture == 3)
        return vec3(clamp((inverse_depth - inverse_depth_range.x) /
                              (inverse_depth_range.y - inverse_depth_range.x),
                          0.0, 1.0));
    return vec3(confidence);
}
#endif
#endif
