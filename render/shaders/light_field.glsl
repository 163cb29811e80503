// The paper without geometry (sections 3 and 4): the scene is a plane, each face blends its three
// photographs with barycentric weights.

#ifdef LUMI_FRAGMENT
vec4 seen(vec3 pixel, float layer) {
    vec4 color = photograph_at_pixel(pixel.xy / max(pixel.z, 1e-20), layer);
    return vec4(color.rgb, pixel.z > 0.0 ? color.a : 0.0);
}

void main() {
    float inverse_depth = max(0.0, AT_CENTRE(side_products_and_plane).w);
    vec3 pixel0 = AT_CENTRE(view_pixel0) + inverse_depth * view_parallax0.xyz;
    vec3 pixel1 = AT_CENTRE(view_pixel1) + inverse_depth * view_parallax1.xyz;
    vec3 pixel2 = AT_CENTRE(view_pixel2) + inverse_depth * view_parallax2.xyz;
    vec4 color0 = seen(pixel0, view_parallax0.w);
    vec4 color1 = seen(pixel1, view_parallax1.w);
    vec4 color2 = seen(pixel2, view_parallax2.w);
    // Beside a camera the others have weights near 0: beyond its photograph they are all there is.
    vec3 counting = vec3(color0.a, color1.a, color2.a);
    vec3 showing = blending_weights() * vec3(greaterThan(counting, vec3(0.0)));
    vec3 weights = showing * counting / max(showing.x + showing.y + showing.z, 1e-20);
    float sum = weights.x + weights.y + weights.z;
    if (sum < kLeastWeight) discard;
    weights /= sum;
#ifdef DEBUG_PICTURE
    drawn = vec4(debug_color(weights, layers_and_face(), inverse_depth, 0.0, 0.0), 1.0);
#else
    drawn = vec4(weights.x * color0.rgb + weights.y * color1.rgb + weights.z * color2.rgb, 1.0);
#endif
#ifdef FADES
    vec3 inside = vec3(inner(pixel0.xy / max(pixel0.z, 1e-20), view_size0.xy),
                       inner(pixel1.xy / max(pixel1.z, 1e-20), view_size1.xy),
                       inner(pixel2.xy / max(pixel2.z, 1e-20), view_size2.xy)) *
                  vec3(greaterThan(vec3(pixel0.z, pixel1.z, pixel2.z), vec3(0.0)));
    drawn *= opacity_of(blending_weights(), inside, dot(blending_weights(), counting), 1.0);
#endif
}
#endif
