#pragma once

#include <optional>

#include "calib/capture/image.h"

namespace lumi {

/// What PSNR is said to be when two pictures are equal to the last bit.
constexpr double kIdenticalPsnrDb = 100.0;

/// The same of a mean squared difference of 8-bit values, in dB.
[[nodiscard]] double psnr_of_mean_square(double mean_square);

/// Peak signal-to-noise ratio of 8-bit sRGB values over all pixels and channels, in dB. Throws
/// Error (E-EVAL-SIZE) when sizes differ.
[[nodiscard]] double psnr_db(const ColorImage& a, const ColorImage& b);

/// The same over the pixels where `coverage` is not 0; empty when there is none.
[[nodiscard]] std::optional<double> psnr_db(const ColorImage& a, const ColorImage& b,
                                            const GrayImage& coverage);

/// Share of pixels that are covered, 0 to 1.
[[nodiscard]] double covered_share(const GrayImage& coverage);

/// The same of the pixels where `subject` is not 0; empty when there is none.
[[nodiscard]] std::optional<double> covered_share(const GrayImage& coverage,
                                                  const GrayImage& subject);

/// BT.601 luma of 8-bit sRGB values, 0 to 255, not rounded.
[[nodiscard]] Image<double> luma(const ColorImage& image);

/// Mean structural similarity of luma: Gaussian window of 11 x 11 with sigma 1.5, K1 = 0.01,
/// K2 = 0.03, L = 255, over all windows that lie in the picture (Wang et al., "Image quality
/// assessment: from error visibility to structural similarity", 2004, eq. 13). Throws Error
/// (E-EVAL-SIZE) when sizes differ or a side is below 11.
[[nodiscard]] double structural_similarity(const ColorImage& a, const ColorImage& b);

}  // namespace lumi
