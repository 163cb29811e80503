#include "calib/ingest/sharpness.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace lumi {

double sharpness(const GrayImage& brightness) {
    const cv::Mat gray(brightness.height(), brightness.width(), CV_8UC1,
                       const_cast<std::uint8_t*>(brightness.row(0)));
    cv::Mat laplacian;
    cv::Laplacian(gray, laplacian, CV_16S);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(laplacian, mean, deviation);
    return deviation[0] * deviation[0];
}

}  // namespace lumi
