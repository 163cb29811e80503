#pragma once

#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// Texels around each photograph that continue it and count nothing, so that it ends where it ends.
inline constexpr int kGutter_px = 1;

/// A photograph in a layer of a texture array, kGutter_px from its top left: red, green, blue and
/// how much each counts, rows from the top. The rest of the layer continues the photograph's border
/// and counts nothing.
[[nodiscard]] std::vector<unsigned char> photograph_layer(const ColorImage& photograph,
                                                          const GrayImage& opacity,
                                                          int layer_width_px, int layer_height_px);

}  // namespace lumi
