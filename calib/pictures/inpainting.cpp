#include "calib/pictures/inpainting.h"

#include <opencv2/core.hpp>
#include <opencv2/photo.hpp>

namespace lumi {

void paint_from_rim(const GrayImage& mask, ColorImage& picture) {
    constexpr double kRadius_px = 4.0;
    cv::Mat covered(mask.height(), mask.width(), CV_8U);
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            covered.at<std::uint8_t>(y, x) = mask(x, y) == 0 ? 255 : 0;
        }
    }
    const cv::Mat colors(picture.height(), picture.width(), CV_8UC3, picture.pixels().data());
    cv::Mat painted;
    cv::inpaint(colors, covered, painted, kRadius_px, cv::INPAINT_TELEA);
    painted.copyTo(colors, covered);
}

}  // namespace lumi
