// Depth, weights and visibility at each pixel, or at each block of two by two pixels; colours at
// each pixel.
//
// The depth is what the layers, one a view, agree on (agreed_depth.glsl, lone_surfaces.glsl). The
// point there is looked up in the three views of the face; those that do not see it lose their
// weight to the others (the paper, section 4, occlusion correction). When none sees it, the view
// that the depth came from does. A view that was asked for depth has said what it sees along the
// eye's ray; of others the depth maps tell. UNASKED_VIEWS: so many of the face's views were not
// asked, its last.
//
// CHECKS_GUESSES: on the scene plane a photograph shows nothing that stands before it, and where one
// shows what is infinitely far behind it, others show nothing.
//
// SMOOTH: a pixel has four samples of depth. Where they are of several surfaces, it is the mean of
// what is drawn of each.
//
// Written for software rendering, where pixels pay for both sides of a branch: what differs between
// them is chosen, divisions are few, and there is no loop but that over the samples of a silhouette.

#ifdef LUMI_FRAGMENT
uniform vec2 viewport_origin;
uniform float near_inverse_depth;        // the scene's near end
uniform float texels_per_pixel;          // of the layers; see depth_eye.h
uniform float texels_below;              // the picture, where it ends within a texel

// Photographs that count less than this, of their weights, hold mixed pixels alone: see
// photograph_opacity.h.
const float kLeastCounting = 0.25;
const float kMostParallax_px = 1.0;
// What a photograph counts beyond its border, which it continues: a quarter of the least within.
const float kLeastOpacity = 1.0 / 1024.0;
// The scale of confidence: see subdivision/blend_triangles.h.
const float kSeenByOne = 0.5;
const float kFilledConfidence = 0.25;
const float kStretchedConfidence = 0.125;

// Where a photograph is looked up for the fragment's centre, and how that moves from pixel to pixel.
struct Place {
    vec2 pixel;
    vec2 along_x;
    vec2 along_y;
    float photograph;
};

// Derivatives of the quotient. `per_pixel`: of the way from fragment to fragment.
Place place_of(InView view, float per_pixel) {
    vec3 along_x = per_pixel * view.along_x;
    vec3 along_y = per_pixel * view.along_y;
    return Place(view.sight.xy, (along_x.xy - view.sight.xy * along_x.z) * view.sight.z,
                 (along_y.xy - view.sight.xy * along_y.z) * view.sight.z, view.photograph);
}

vec4 color_of(Place place, vec2 from_centre_px) {
#ifdef BLOCKS
    place.pixel += from_centre_px.x * place.along_x + from_centre_px.y * place.along_y;
#endif
    return photograph_at_pixel(place.pixel, place.photograph);
}

// What all pixels of a fragment share.
struct Blend {
    Place place0;  // in the view that knows the depth, where none of the three sees the point
    Place place1;
    Place place2;
    vec3 weights;  // of those that see the point
    float sum;     // of these weights
    bool is_unseen;
    Depth depth;
    bool is_guess;  // no depth is known: the scene plane
    float inverse_depth;
#ifdef FADES
    vec3 ray_weights;  // before the correction
    vec3 inside;       // of each photograph: how far
#endif
};

// The colour that the photographs come to, and how far it is known.
vec4 drawn_at(Blend blend, vec2 from_centre_px) {
    vec4 color0 = color_of(blend.place0, from_centre_px);
    vec4 color1 = color_of(blend.place1, from_centre_px);
    vec4 color2 = color_of(blend.place2, from_centre_px);
    // Only the middle of a block needs to be within a photograph, and the borders of mip levels count
    // nothing: whom no other sees better is seen all the same.
    vec3 weights = blend.weights * max(vec3(color0.a, color1.a, color2.a), kLeastOpacity);
    float counting = weights.x + weights.y + weights.z;
    // Where all are mixed of two surfaces the colour is a guess, unless a camera is where the eye is.
    float pure = counting + dot(blend.weights, step(near_inverse_depth * disparity_and_face.xyz,
                                                    vec3(kMostParallax_px)));
    // What none of the three sees and no view has seen is drawn as a guess too.
    float is_known = blend.is_guess || (blend.is_unseen && blend.depth.kind > kSeenOrFilled) ? 0.0 : 1.0;
    float covered = is_known * (blend.is_unseen ? 1.0 : step(kLeastCounting * blend.sum, pure));
    covered = blend.depth.is_behind_tears ? 0.0 : covered;
    weights = blend.is_unseen ? vec3(1.0, 0.0, 0.0) : weights * (1.0 / max(counting, 1e-9));
#ifdef FADES
    // A shell is laid over by its alpha: it hides what is beneath.
    covered = mix(covered, is_known, is_shell);
#endif
#ifdef DEBUG_PICTURE
    // Two views agree: 1; a guess: 0.
    float confidence = blend.depth.is_behind_tears        ? kStretchedConfidence
                       : blend.depth.kind < kSeen         ? kSeenByOne * blend.depth.support
                       : blend.depth.kind < kSeenOrFilled ? kFilledConfidence
                       : blend.is_guess                   ? 0.0
                                                          : kStretchedConfidence;
    // White: none of the three sees the point.
    bool is_marked = blend.is_unseen && debug_picture == SHOW_WEIGHTS;
    vec3 shown = is_marked ? vec3(1.0)
                           : debug_color(weights, layers_and_face(), blend.inverse_depth,
                                         confidence, blend.is_unseen ? 1.0 : 1.0 - blend.sum);
#else
    vec3 shown = weights.x * color0.rgb + weights.y * color1.rgb + weights.z * color2.rgb;
#endif
#ifdef FADES
    return vec4(shown, covered) * opacity_of(blend.ray_weights, blend.inside,
                                             blend.is_unseen ? 0.0 : counting, is_known);
#else
    return vec4(shown, covered);
#endif
}

ivec2 texel_at(vec2 window) {
    return ivec2(window * texels_per_pixel + vec2(0.0, texels_below));
}

Blend blend_at(vec2 window, Depth depth) {
    Blend blend;
    blend.depth = depth;
    // Where no depth is known the scene plane is a guess: drawn, but not counted as covered.
    blend.is_guess = depth.kind > kKnown;
    float q = blend.is_guess ? max(0.0, side_products_and_plane.w) : depth.inverse_depth;
    blend.inverse_depth = q;
    // Not in the choices below, behind which derivatives are undefined.
    InView view0 = in_view(view_pixel0, view_parallax0, q);
    InView view1 = in_view(view_pixel1, view_parallax1, q);
    InView view2 = in_view(view_pixel2, view_parallax2, q);
    vec3 weights = blending_weights();
#ifdef FADES
    blend.ray_weights = weights;
    blend.inside = vec3(inner(view0.sight.xy, view_size0.xy), inner(view1.sight.xy, view_size1.xy),
                        inner(view2.sight.xy, view_size2.xy));
#endif
    weights *= visibilities(view0, view1, view2, depth, q, blend.is_guess);
#ifdef CHECKS_GUESSES
    vec3 showing = showing_guess(view0, view1, view2, q, weights);
    weights *= blend.is_guess ? showing : vec3(1.0);
#endif
    blend.weights = weights;
    blend.sum = weights.x + weights.y + weights.z;
    blend.is_unseen = blend.sum < kLeastWeight;
    // What is stretched over a tear is steep: the next pixel of the block is much farther, and shows
    // nearly the same, not what is beside it at this depth.
    bool is_stretched = depth.kind > kSeenOrFilled && !blend.is_guess;
    float per_pixel = is_stretched ? 0.0 : 1.0 / kFragment_px;
    blend.place0 = place_of(
        chosen(blend.is_unseen, in_view_of_layer(depth.layer, window, q), view0), per_pixel);
    blend.place1 = place_of(view1, per_pixel);
    blend.place2 = place_of(view2, per_pixel);
    return blend;
}

#ifdef SMOOTH
// 1 where no layer tells the depths apart.
float is_one_surface(vec4 a, vec4 b) {
    return all(lessThanEqual(abs(a - b), vec4(agreeing_depth))) ? 1.0 : 0.0;
}

// Samples of what lies behind tears count where there are no others: they are none of an outline.
const float kBehindTears = 1e-3;

// The mean of a pixel's four samples of depth, less those where nothing is known. Each round draws
// one surface, at the mean of the samples that are of it.
vec4 smooth_at(vec2 window) {
    ivec2 texel = texel_at(window - 0.25);
    vec4 depth0 = settled_depths(texel);
    vec4 depth1 = settled_depths(texel + ivec2(1, 0));
    vec4 depth2 = settled_depths(texel + ivec2(0, 1));
    vec4 depth3 = settled_depths(texel + ivec2(1, 1));
    vec4 left = vec4(1.0);  // 1 for samples that are not drawn yet
    vec4 sum = vec4(0.0);
    float count = 0.0;
    // Asked at its end, no round is begun that nothing comes of.
    do {
        vec4 first = left.x > 0.5   ? depth0
                     : left.y > 0.5 ? depth1
                     : left.z > 0.5 ? depth2
                                    : depth3;
        vec4 of_surface = left * vec4(is_one_surface(depth0, first), is_one_surface(depth1, first),
                                      is_one_surface(depth2, first), is_one_surface(depth3, first));
        left -= of_surface;
        float samples = dot(of_surface, vec4(1.0));
        vec4 mean = (of_surface.x * depth0 + of_surface.y * depth1 + of_surface.z * depth2 +
                     of_surface.w * depth3) / samples;
        Blend blend = blend_at(window, agreed_depth(mean, behind_tears(first)));
        float drawn_samples = blend.is_unseen && blend.is_guess ? 0.0 : samples;
        drawn_samples *= blend.depth.is_behind_tears ? kBehindTears : 1.0;
        sum += drawn_samples * drawn_at(blend, vec2(0.0));
        count += drawn_samples;
    } while (dot(left, vec4(1.0)) > 0.5);
    if (count <= 0.0) discard;
    return vec4(sum.rgb / count, step(0.5 * count, sum.a));
}
#endif

void main() {
    vec2 window = kFragment_px * gl_FragCoord.xy - viewport_origin;
#ifdef SMOOTH
    drawn = smooth_at(window);
#else
    vec4 depths = settled_depths(texel_at(window));
    Blend blend = blend_at(window, agreed_depth(depths, behind_tears(depths)));
    if (blend.is_unseen && blend.is_guess) discard;
#ifdef BLOCKS
    drawn = drawn_at(blend, vec2(-0.5, -0.5));
    drawn_right = drawn_at(blend, vec2(0.5, -0.5));
    drawn_above = drawn_at(blend, vec2(-0.5, 0.5));
    drawn_above_right = drawn_at(blend, vec2(0.5, 0.5));
#else
    drawn = drawn_at(blend, vec2(0.0));
#endif
#endif
}
#endif
