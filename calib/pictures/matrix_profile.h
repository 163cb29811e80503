#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// An ICC profile of three curves and a matrix, as those of cameras and telephones are.
///
/// Evaluated here: Little CMS does it exactly in 0.4 microseconds a pixel, and faster from 16 bits
/// only by way of a coarse grid, which is off by as much as 19 of 255 in shadows.
class MatrixProfile {
 public:
    /// `profile`: a cmsHPROFILE. Empty when it is of another kind, or when its black is not black.
    [[nodiscard]] static std::optional<MatrixProfile> of(void* profile);

    /// To the nearest level of sRGB, relative to white; what sRGB lacks is taken to its rim.
    [[nodiscard]] Rgb8 srgb_of(std::uint16_t r, std::uint16_t g, std::uint16_t b) const;

 private:
    std::array<std::vector<float>, 3> light_;  ///< Of every 16-bit value, 0 to 1.
    Eigen::Matrix3f srgb_from_profile_;        ///< Between lights.
};

}  // namespace lumi
