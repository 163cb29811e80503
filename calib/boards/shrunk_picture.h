#pragma once

#include <opencv2/core.hpp>

#include "calib/capture/image.h"

namespace lumi {

/// The picture in which shapes are looked for: the longer side at most 1600 pixels, each at least
/// one. Of a picture that is no larger a view, which must not be written through.
[[nodiscard]] cv::Mat shrunk_picture(const GrayImage& picture);

}  // namespace lumi
