#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// OpenCV's view of a picture, without a copy. It must not be written through.
[[nodiscard]] inline cv::Mat opencv_view(const GrayImage& picture) {
    return {picture.height(), picture.width(), CV_8UC1,
            const_cast<std::uint8_t*>(picture.pixels().data())};
}

/// OpenCV's (0, 0) is the centre of the top-left pixel, which is our (0.5, 0.5).
constexpr double kOurPixelFromOpenCv = 0.5;

[[nodiscard]] inline Eigen::Vector2d from_opencv(const cv::Point2f& point) {
    return {static_cast<double>(point.x) + kOurPixelFromOpenCv,
            static_cast<double>(point.y) + kOurPixelFromOpenCv};
}

[[nodiscard]] inline cv::Point2f to_opencv(const Eigen::Vector2d& px) {
    return {static_cast<float>(px.x() - kOurPixelFromOpenCv),
            static_cast<float>(px.y() - kOurPixelFromOpenCv)};
}

}  // namespace lumi
