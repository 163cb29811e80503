#pragma once

#include <array>
#include <string>

#include "calib/capture/image.h"

namespace lumi {

/// What one photograph is worth as a picture, in grey levels of 8 bits and pixels of the picture
/// that was looked at.
struct PhotographQuality {
    std::string name;
    int longer_side_px = 0;
    double mean_linear = 0.0;    ///< Mean brightness as the sensor receives it, 0 to 1.
    double clipped_share = 0.0;  ///< Pixels that are black or white.
    double noise_sigma = 0.0;    ///< Standard deviation of the sensor's noise.
    double blur_sigma_px = 0.0;  ///< Of the Gaussian that the detail looks blurred with.
    /// Standard deviation of what the picture shows between scales of 1 and 2, 2 and 4, 4 and 8,
    /// 8 and 16 pixels, noise taken off.
    std::array<double, 4> detail{};
    int features = 0;

    /// Contrast that is there at any scale.
    [[nodiscard]] double contrast() const;
    /// Contrast in multiples of the noise that is left at its scale.
    double signal_to_noise = 0.0;
};

/// Noise: the median absolute response of a filter that answers neither to planes nor to parabolas
/// (Immerkaer, Fast noise variance estimation, CVIU 1996), in the quieter part of the picture.
/// Detail: differences of Gaussians. Blur: the Gaussian that explains how detail falls off towards
/// fine scales, for pictures whose sharp detail is as strong at every scale (Field, Relations
/// between the statistics of natural images, JOSA A 1987). `features` and `name` stay empty.
[[nodiscard]] PhotographQuality quality_of(const ColorImage& picture);

}  // namespace lumi
