// Four pictures of half the size become the frame: each holds one pixel of every block of two by
// two (pixel_blocks.h).

#ifdef LUMI_FRAGMENT
uniform sampler2DArray blocks;
uniform vec2 from_origin_px;  // of the picture that the blocks make: its first block begins there
out vec4 drawn;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy + from_origin_px);
    drawn = texelFetch(blocks, ivec3(pixel >> 1, (pixel.x & 1) + 2 * (pixel.y & 1)), 0);
}
#endif
