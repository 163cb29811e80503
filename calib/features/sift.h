#pragma once

#include "calib/capture/image.h"
#include "calib/features/features.h"

namespace lumi {

struct SiftOptions {
    int max_features = 4096;  ///< The strongest are kept. > 0.
    /// Three times the least difference of Gaussians, grey values in [0, 1] (Lowe 2004, section 4):
    /// OpenCV divides it by the layers of an octave, of which there are three.
    double contrast_threshold = 0.0133;
};

/// Scale-invariant features (Lowe, IJCV 2004) of a grey picture, the same for any number of
/// threads. Sorted by falling scale, then by place. Where a `mask` of the picture's size is 0 none
/// is kept, nor counted as one of the strongest.
[[nodiscard]] Features detect_sift(const GrayImage& image, const SiftOptions& options,
                                   const GrayImage& mask = {});

}  // namespace lumi
