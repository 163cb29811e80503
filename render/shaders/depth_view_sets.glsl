// Which set of views a texel of the depth layers asks (depth_view_choice.h).

#ifdef LUMI_FRAGMENT
uniform vec4 set_ends;  // shares of the sets, summed up; 1 from the last set on

// The same as set_at in render/modes/depth_view_choice.cpp.
int set_at(ivec2 texel) {
    uint number = 3242174889u * uint(texel.x) + 2447445414u * uint(texel.y);
    float place = float(number >> 8) / 16777216.0;
    return int(dot(vec4(greaterThanEqual(vec4(place), set_ends)), vec4(1.0)));
}
#endif
