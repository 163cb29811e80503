#pragma once

#include <cstdint>
#include <opencv2/core.hpp>

#include "calib/ingest/image_rectangle.h"

namespace lumi {

/// 255 where `is(x, y)` holds within the rectangle, 0 elsewhere; in the raster of the rectangle.
template <typename Predicate>
[[nodiscard]] cv::Mat pixels_where(const ImageRectangle& within, const Predicate& is) {
    cv::Mat pixels = cv::Mat::zeros(within.height_px, within.width_px, CV_8U);
    for (int y = 0; y < within.height_px; ++y) {
        for (int x = 0; x < within.width_px; ++x) {
            if (is(within.left + x, within.top + y)) pixels.at<std::uint8_t>(y, x) = 255;
        }
    }
    return pixels;
}

/// By so many pixels to all sides, and to the corners.
[[nodiscard]] cv::Mat grown(const cv::Mat& pixels, int radius_px);

/// Connected pixels that are not 0; part 0 is all others.
struct PixelParts {
    cv::Mat part_of;  ///< The part of each pixel.
    cv::Mat boxes;    ///< OpenCV's statistics, a row a part.
    int count = 0;    ///< With part 0.

    explicit PixelParts(const cv::Mat& pixels, int connectivity = 8);
    [[nodiscard]] int area_px(int part) const;
    /// With a margin, within the picture.
    [[nodiscard]] cv::Rect around(int part, int margin_px) const;
};

}  // namespace lumi
