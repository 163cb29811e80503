#pragma once

#include <string>

#include "calib/capture/image.h"

namespace lumi {

/// What is wrong with a photograph in which nothing could be found, in the words of a photographer:
/// too dark, overexposed, blurred; empty when nothing stands out.
[[nodiscard]] std::string picture_fault(const GrayImage& picture);

}  // namespace lumi
