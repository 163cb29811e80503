#pragma once

namespace lumi {

/// Sections of a configuration for tests of what surrounds depth and drawing: depth comes from
/// scene points alone, and photographs are not asked how they are to be drawn. A small build then
/// takes a tenth of its time.
inline constexpr const char* kSparseDepth = "[depth]\nmodel = \"sparse\"\n";
inline constexpr const char* kToldDrawing =
    "[render]\ndepth_views = 4\ndepth_block_px = 1\nfill_holes = \"no\"\ncheck_guesses = \"no\"\n"
    "draw_thin = \"no\"\ntriangle_error_px = 0.7\nocclusion_tolerance_px = 1.5\n"
    "noisy_depth_error_px = 1.6\n";

}  // namespace lumi
