#include "calib/ingest/sharpness.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/capture/gray.h"

namespace lumi {

double sharpness(const ColorImage& picture) {
    const GrayImage gray = gray_of(picture);
    const cv::Mat brightness(gray.height(), gray.width(), CV_8UC1,
                             const_cast<std::uint8_t*>(gray.row(0)));
    cv::Mat laplacian;
    cv::Laplacian(brightness, laplacian, CV_16S);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(laplacian, mean, deviation);
    return deviation[0] * deviation[0];
}

}  // namespace lumi
