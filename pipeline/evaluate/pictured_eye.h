#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {

/// A photograph and the eye that it was taken with: what a Lumigraph should show there.
struct PicturedEye {
    Eye eye;
    ColorImage photograph;
};

/// Some of a Lumigraph's own views, to be drawn from the others.
struct KeptBackViews {
    std::vector<PicturedEye> pictures;
    std::vector<int> others;  ///< Indices of the views, ascending.
};

/// Keeps back every so many views, of which the first is `first`.
[[nodiscard]] KeptBackViews keep_back(const Lumigraph& lumigraph, int every, int first);

/// The picture in a size of at most so many pixels across.
[[nodiscard]] PicturedEye no_larger_than(PicturedEye picture, int max_px);

/// How close a Lumigraph comes to photographs, and how fast: of each.
struct DrawnPictures {
    std::vector<double> losses_db;  ///< Minus the PSNR, full frame.
    std::vector<double> frame_ms;
    std::vector<double> triangles;
};

/// Draws one more.
void draw_picture(OffscreenRenderer& renderer, const PicturedEye& picture,
                  const RenderOptions& options, DrawnPictures& drawn);

/// Draws each per pixel. Throws Error (E-GL-...).
[[nodiscard]] DrawnPictures draw_pictures(const Lumigraph& lumigraph,
                                          const std::vector<PicturedEye>& pictures);

}  // namespace lumi
