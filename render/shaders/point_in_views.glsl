// A point as the views of its face see it, and whether they do (the paper, section 4, occlusion
// correction). What render/reference/point_in_views.h says in plain code.

#ifdef LUMI_FRAGMENT
uniform sampler2DArray depth_maps;
uniform float check_per_px;  // 1 / tolerance; 0 without occlusion correction

// Of disparity: what stands so far before a point hides it. See occlusion.h.
const float kSurelyBefore_px = 16.0;

const int kAskedViews = 3 - UNASKED_VIEWS;

#ifdef BLOCKS
const float kFragment_px = 2.0;
// How what is affine in the picture moves from fragment to fragment.
#define ALONG_X(v) dFdx(v)
#define ALONG_Y(v) dFdy(v)
#else
const float kFragment_px = 1.0;
// Not asked for. Smooth silhouettes are drawn in rounds that neighbours leave one by one, where
// derivatives are undefined.
#define ALONG_X(v) vec3(0.0)
#define ALONG_Y(v) vec3(0.0)
#endif

// A view at a point: xy its pixel, z the inverse of its homogeneous coordinate.
vec3 sight_of(vec3 pixel) {
    float inverse = 1.0 / max(pixel.z, 1e-20);
    return vec3(pixel.xy * inverse, inverse);
}

// The fragment's point in a view, and how its homogeneous pixel moves from fragment to fragment.
struct InView {
    vec3 sight;
    bool is_before;
    vec3 along_x;
    vec3 along_y;
    float photograph;
};

// Of `at_infinity` the pixel at inverse depth 0, of `parallax` what each unit of it adds, and the
// photograph.
InView in_view(vec3 at_infinity, vec4 parallax, float inverse_depth) {
    vec3 pixel = AT_CENTRE(at_infinity) + inverse_depth * parallax.xyz;
    return InView(sight_of(pixel), pixel.z > 0.0, ALONG_X(at_infinity), ALONG_Y(at_infinity),
                  parallax.w);
}

// The same in the view of a layer.
InView in_view_of_layer(int layer, vec2 window, float inverse_depth) {
    vec3 pixel = pixel_in_layer(layer, vec4(window, 1.0, inverse_depth));
    return InView(sight_of(pixel), pixel.z > 0.0,
                  pixel_in_layer(layer, vec4(kFragment_px, 0.0, 0.0, 0.0)),
                  pixel_in_layer(layer, vec4(0.0, kFragment_px, 0.0, 0.0)),
                  photograph_of_layer(layer));
}

InView chosen(bool is_first, InView first, InView second) {
    return InView(is_first ? first.sight : second.sight,
                  is_first ? first.is_before : second.is_before,
                  is_first ? first.along_x : second.along_x,
                  is_first ? first.along_y : second.along_y,
                  is_first ? first.photograph : second.photograph);
}

// The sample of the view's depth map, of what lies outside the nearest. `size` is that of the
// photograph, and samples of the depth map for each of its pixels.
float sample_at(InView view, vec4 size) {
    vec2 texel = max(min(view.sight.xy * size.zw, size.xy * size.zw - 0.5), 0.0);
    return texelFetch(depth_maps, ivec3(ivec2(texel), int(view.photograph)), 0).r;
}

// The inverse depth in the view of what it sees there.
float seen_by(bool is_asked, InView view, vec4 size, Depth depth) {
    if (is_asked)
        return dot(layer_of_photograph(view.photograph), depth.of_layers) * view.sight.z;
    return sample_at(view, size);
}

// 1 when the view sees the point, 0 when it sees something else; in between a ramp.
float visibility(bool is_asked, InView view, vec4 size, Depth depth, float inverse_depth,
                 float disparity_px, float check) {
    vec2 to_border = min(view.sight.xy, size.xy - view.sight.xy);
    bool is_inside = view.is_before && min(to_border.x, to_border.y) >= 0.0;
    float seen = seen_by(is_asked, view, size, depth);
    float difference_px = abs(inverse_depth * view.sight.z - seen) * disparity_px;
    return is_inside ? clamp(2.0 - check * difference_px, 0.0, 1.0) : 0.0;
}

// How far each of the face's views sees the point.
vec3 visibilities(InView view0, InView view1, InView view2, Depth depth, float inverse_depth,
                  bool is_guess) {
    float check = is_guess ? 0.0 : check_per_px;
    return vec3(visibility(kAskedViews > 0, view0, view_size0, depth, inverse_depth,
                           disparity_and_face.x, check),
                visibility(kAskedViews > 1, view1, view_size1, depth, inverse_depth,
                           disparity_and_face.y, check),
                visibility(kAskedViews > 2, view2, view_size2, depth, inverse_depth,
                           disparity_and_face.z, check));
}

#ifdef CHECKS_GUESSES
// Which of the face's views may show a point that is a guess: those that have nothing before it;
// of these, if any, those that see past it, infinitely far.
vec3 showing_guess(InView view0, InView view1, InView view2, float inverse_depth, vec3 weights) {
    vec3 seen = vec3(sample_at(view0, view_size0), sample_at(view1, view_size1),
                     sample_at(view2, view_size2));
    vec3 there = inverse_depth * vec3(view0.sight.z, view1.sight.z, view2.sight.z);
    vec3 free = step((seen - there) * disparity_and_face.xyz, vec3(kSurelyBefore_px));
    vec3 past = vec3(lessThanEqual(seen, vec3(0.0)));
    return dot(weights, past) < kLeastWeight ? free : past;
}
#endif
#endif
