// Four pictures of half the size become the frame: each holds one pixel of every block of two by
// two (pixel_blocks.h).

#ifdef LUMI_FRAGMENT
uniform sampler2DArray blocks;
uniform vec2 from_origin_px;  // of the picture that the blocks make: its first block begins there
out vec4 drawn;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy + from_origin_px);
    vec4 color = texelFetch(blocks, ivec3(pixel >> 1, (pixel.x & 1) + 2 * (pixel.y & 1)), 0);
    // 0: nothing was drawn there; a half: a guess; 1: covered.
    if (color.a < 0.25) discard;
    drawn = vec4(color.rgb, step(0.75, color.a));
}
#endif
