// Colours of the photographs, and the colours of debug pictures: what all programs share.

// Photographs lie so many texels from the top left of their layers (uploaded_lumigraph.h).
const float kGutter_px = 1.0;

#ifdef LUMI_FRAGMENT
// A pixel that all views together count less for is empty. As in occlusion.h.
const float kLeastWeight = 1e-4;

uniform sampler2DArray photographs;

#ifdef MIP_LEVELS
uniform float photograph_lod;  // see photograph_lod.h
#endif

// A colour of a layer, whose coordinates run from 0 to 1; encoded sRGB, blended as such. Alpha is
// how much it counts: 0 beyond the photograph.
vec4 photograph_at(vec2 on_layer, float layer) {
#ifdef MIP_LEVELS
    return textureLod(photographs, vec3(on_layer, layer), photograph_lod);
#else
    return textureLod(photographs, vec3(on_layer, layer), 0.0);
#endif
}

#ifdef FOUR_SAMPLES
// Four samples a pixel tell surfaces apart; photographs are looked up for its centre, so that the
// mean of the four does not blur them. For what is affine in the picture, or nearly.
vec2 to_centre() { return 0.5 - mod(floor(gl_FragCoord.xy), 2.0); }
#define AT_CENTRE(v) ((v) + to_centre().x * dFdx(v) + to_centre().y * dFdy(v))

// Where a photograph is looked up on a triangle, in its layer. What lies more than a texel from the
// centre is looked up by itself: on surfaces at a slant four lookups apart blur nothing, and beside
// those that are seen edge on derivatives lead anywhere.
vec2 place_at_centre(vec2 on_layer) {
    vec2 way = to_centre().x * dFdx(on_layer) + to_centre().y * dFdy(on_layer);
#ifdef MIP_LEVELS
    vec2 texels = way * vec2(textureSize(photographs, int(photograph_lod)).xy);
#else
    vec2 texels = way * vec2(textureSize(photographs, 0).xy);
#endif
    return max(abs(texels.x), abs(texels.y)) <= 1.0 ? on_layer + way : on_layer;
}
#define PLACE_AT_CENTRE(v) place_at_centre(v)
#else
#define AT_CENTRE(v) (v)
#define PLACE_AT_CENTRE(v) (v)
#endif

#ifdef DEBUG_PICTURE
uniform int debug_picture;         // DebugPicture in frame.h, of which some are defined: SHOW_...
uniform vec2 inverse_depth_range;  // far, near: black and white in the depth picture

// A colour for an index; neighbours differ (golden ratio).
vec3 index_color(float index) {
    return 0.5 + 0.5 * cos(6.2831853 * (fract(0.618034 * index) + vec3(0.0, 0.3333333, 0.6666667)));
}

vec3 debug_color(vec3 weights, vec4 layers_and_face, float inverse_depth, float confidence,
                 float occluded) {
    if (debug_picture == SHOW_WEIGHTS)
        return weights.x * index_color(layers_and_face.x) +
               weights.y * index_color(layers_and_face.y) +
               weights.z * index_color(layers_and_face.z);
    if (debug_picture == SHOW_FACES) return index_color(layers_and_face.w);
    if (debug_picture == SHOW_DEPTH)
        return vec3(clamp((inverse_depth - inverse_depth_range.x) /
                              (inverse_depth_range.y - inverse_depth_range.x),
                          0.0, 1.0));
    return vec3(debug_picture == SHOW_CONFIDENCE ? confidence : occluded);
}
#endif
#endif
