// For each cell of the picture, of the places in it that are looked at, the share at which no view
// that was asked for depth sees the scene: what it shows there is stretched over a tear, lies behind
// such a tear, or is nothing.
// The cells' rows count from the top of the picture, here as in holes/hole_cells.h.

#ifdef LUMI_FRAGMENT
uniform float cell_px;
uniform vec2 picture_size;
uniform float texels_per_pixel;
uniform float texel_rows;
out vec4 drawn;

void main() {
    float holes = 0.0;
    float inside = 0.0;
    for (int number = 0; number < SAMPLES * SAMPLES; ++number) {
        vec2 in_cell = vec2(number % SAMPLES, number / SAMPLES) + 0.5;
        vec2 pixel = cell_px * (floor(gl_FragCoord.xy) + in_cell / float(SAMPLES));
        if (any(greaterThanEqual(pixel, picture_size))) continue;
        vec2 texel = pixel * texels_per_pixel;
        // Places lie on the sides of texels: those below and to the right are looked at.
        vec2 from_bottom_left = vec2(texel.x, texel_rows - 1.0 - floor(texel.y));
        vec4 depths = layer_depths(ivec2(from_bottom_left));
        Depth depth = agreed_depth(depths, behind_tears(depths));
        inside += 1.0;
        holes += depth.kind > kSeenOrFilled || depth.is_behind_tears ? 1.0 : 0.0;
    }
    drawn = vec4(holes / max(inside, 1.0));
}
#endif
