// What a fragment draws: a pixel, or the pixels of a block of two by two (pixel_blocks.h).

#ifdef LUMI_FRAGMENT
layout(location = 0) out vec4 drawn;
#ifdef BLOCKS
layout(location = 1) out vec4 drawn_right;
layout(location = 2) out vec4 drawn_above;
layout(location = 3) out vec4 drawn_above_right;
#endif
#endif
