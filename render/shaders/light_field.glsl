// The paper without geometry (sections 3 and 4): the scene is a plane, each face blends its three
// photographs with barycentric weights. A view that the point lies outside of counts nothing.

#ifdef LUMI_FRAGMENT
void main() {
    float inverse_depth = max(0.0, side_products_and_plane.w);
    vec3 pixel0 = view_pixel0 + inverse_depth * view_parallax0.xyz;
    vec3 pixel1 = view_pixel1 + inverse_depth * view_parallax1.xyz;
    vec3 pixel2 = view_pixel2 + inverse_depth * view_parallax2.xyz;
    vec3 weights = blending_weights() * vec3(feather(pixel0, view_size0.xy),
                                             feather(pixel1, view_size1.xy),
                                             feather(pixel2, view_size2.xy));
    float sum = weights.x + weights.y + weights.z;
    if (sum < 1e-4) discard;
    weights /= sum;
#ifdef DEBUG_PICTURE
    drawn = vec4(debug_color(weights, layers_and_face(), inverse_depth, 0.0), 1.0);
#else
    drawn = vec4(weights.x * photograph(pixel0, view_size0.xy, view_parallax0.w) +
                     weights.y * photograph(pixel1, view_size1.xy, view_parallax1.w) +
                     weights.z * photograph(pixel2, view_size2.xy, view_parallax2.w),
                 1.0);
#endif
}
#endif
