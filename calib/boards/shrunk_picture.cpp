#include "calib/boards/shrunk_picture.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "calib/opencv/opencv_picture.h"

namespace lumi {

cv::Mat shrunk_picture(const GrayImage& picture) {
    constexpr double kLongSide_px = 1600;
    const double scale = kLongSide_px / std::max(picture.width(), picture.height());
    if (scale >= 1) return opencv_view(picture);
    const auto scaled = [&](int side_px) {
        return std::max(1, static_cast<int>(std::lround(scale * side_px)));
    };
    cv::Mat small;
    cv::resize(opencv_view(picture), small, {scaled(picture.width()), scaled(picture.height())}, 0,
               0, cv::INTER_AREA);
    return small;
}

}  // namespace lumi
