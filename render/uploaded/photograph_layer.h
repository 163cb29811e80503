#pragma once

#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// The margin around each photograph, in texels: it repeats the photograph's border with opacity 0,
/// so that filtering fades the photograph out exactly at its border.
inline constexpr int kGutter_px = 1;

/// A photograph in a layer of a texture array, kGutter_px from its top left: red, green, blue and
/// opacity, rows from the top. Around it the layer repeats the photograph's border with opacity 0.
[[nodiscard]] std::vector<unsigned char> photograph_layer(const ColorImage& photograph,
                                                          const GrayImage& opacity,
                                                          int layer_width_px, int layer_height_px);

}  // namespace lumi
