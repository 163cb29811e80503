#pragma once

#include <algorithm>
#include <opencv2/core.hpp>

#include "calib/capture/image.h"

namespace lumi {

/// A copy of the matrix's pixels, which must be of the type `Pixel`.
template <class Pixel>
[[nodiscard]] Image<Pixel> image_of(const cv::Mat& matrix) {
    Image<Pixel> image(matrix.cols, matrix.rows);
    for (int y = 0; y < matrix.rows; ++y) {
        const auto* row = matrix.ptr<Pixel>(y);
        std::copy(row, row + matrix.cols, image.row(y));
    }
    return image;
}

/// A view of the pixels for OpenCV, which must only read them; `type` is OpenCV's for `Pixel`.
template <class Pixel>
[[nodiscard]] cv::Mat matrix_of(const Image<Pixel>& image, int type) {
    return {image.height(), image.width(), type, const_cast<Pixel*>(image.row(0))};
}

}  // namespace lumi
