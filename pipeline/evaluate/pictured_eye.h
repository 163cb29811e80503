#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {

/// A photograph and the eye that it was taken with: what a Lumigraph should show there.
struct PicturedEye {
    Eye eye;
    ColorImage photograph;
    double falloff = 0.0;  ///< Of the lens (light_left.h): in the photograph, and not in drawings.
};

/// Some of a Lumigraph's own views, to be drawn from the others.
struct KeptBackViews {
    std::vector<PicturedEye> pictures;
    std::vector<int> others;  ///< Indices of the views, ascending.
};

/// Keeps back every so many views, of which the first is `first`; their photographs are in the
/// exposure of those around them (even_exposure.h).
[[nodiscard]] KeptBackViews keep_back(const Lumigraph& lumigraph, int every, int first);

/// The picture in a size of at most so many pixels across.
[[nodiscard]] PicturedEye no_larger_than(PicturedEye picture, int max_px);

/// How close a Lumigraph comes to photographs, and how fast: for each of them.
struct DrawnPictures {
    std::vector<double> losses_db;  ///< Minus the PSNR, full frame.
    std::vector<double> frame_ms;   ///< Wall time.
    std::vector<double> triangles;  ///< That the frame took.
};

/// Draws one more, and adds what it measured to `drawn`.
void draw_picture(OffscreenRenderer& renderer, const PicturedEye& picture,
                  const RenderOptions& options, DrawnPictures& drawn);

/// Draws each.
[[nodiscard]] DrawnPictures draw_pictures(OffscreenRenderer& renderer,
                                          const std::vector<PicturedEye>& pictures,
                                          const RenderOptions& options);

/// Draws each per pixel. Throws Error (E-GL-...).
[[nodiscard]] DrawnPictures draw_pictures(const Lumigraph& lumigraph,
                                          const std::vector<PicturedEye>& pictures);

}  // namespace lumi
