#pragma once

#include <string>

#include "calib/capture/image.h"

namespace lumi {

/// How two pictures of one size differ, in steps of 1/255.
struct FrameDifference {
    double mean = 0.0;              ///< Over pixels and channels.
    double share_beyond_two = 0.0;  ///< Pixels of which a channel differs by more than 2.
    int largest = 0;
    int largest_of_patches = 0;  ///< By which all of some 3 x 3 pixels differ at least.
};

[[nodiscard]] ColorImage as_color(const GrayImage& gray);

[[nodiscard]] FrameDifference difference_between(const ColorImage& a, const ColorImage& b);

}  // namespace lumi
