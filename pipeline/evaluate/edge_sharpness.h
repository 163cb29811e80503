#pragma once

#include <optional>

#include "calib/capture/image.h"

namespace lumi {

/// How sharp a rendering is beside its photograph: the ratio of their gradient energies (sum of
/// squared central differences of luma) over the pixels whose neighbours are covered, too. Below 1:
/// blurred; above 1: noise or false edges. Empty when nothing is covered, or when the photograph
/// has no gradient at all. Throws Error (E-EVAL-SIZE) when sizes differ.
[[nodiscard]] std::optional<double> edge_sharpness(const ColorImage& photograph,
                                                   const ColorImage& rendering,
                                                   const GrayImage& coverage);

}  // namespace lumi
