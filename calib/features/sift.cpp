#include "calib/features/sift.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <opencv2/features2d.hpp>
#include <tuple>

namespace lumi {
namespace {

// OpenCV 4.6 doubles the picture with pixel centres aligned, but halves the coordinates as if
// corners were: a feature is reported a quarter of a pixel too far to the right and below
// (opencv#23123). OpenCV's (0, 0) is our (0.5, 0.5).
constexpr float kOurPixelFromSift = 0.5F - 0.25F;

Descriptor root_sift(const float* sift) {
    const float sum = std::accumulate(sift, sift + kDescriptorSize, 0.0F);
    Descriptor result{};
    if (!(sum > 0)) return result;
    for (std::size_t bin = 0; bin < kDescriptorSize; ++bin) {
        const float root = std::sqrt(std::max(sift[bin], 0.0F) / sum);
        result[bin] = static_cast<std::uint8_t>(std::min(std::lround(512.0F * root), 255L));
    }
    return result;
}

/// A total order, so that the result does not depend on the order in which threads found them.
auto order_of(const cv::KeyPoint& point) {
    return std::tuple(-point.size, point.pt.y, point.pt.x, point.angle, point.response);
}

struct DescribedPoints {
    std::vector<cv::KeyPoint> points;
    cv::Mat descriptors;
};

bool is_hidden(const cv::KeyPoint& point, const GrayImage& mask) {
    const auto at = [](float pixel, int size) {
        return std::clamp(static_cast<int>(pixel + kOurPixelFromSift), 0, size - 1);
    };
    return mask(at(point.pt.x, mask.width()), at(point.pt.y, mask.height())) == 0;
}

/// OpenCV looks at a mask after it has chosen the strongest features, most of which may be hidden.
DescribedPoints described_points(cv::SIFT& sift, const cv::Mat& picture, const GrayImage& mask,
                                 int max_features) {
    DescribedPoints found;
    if (mask.empty()) {
        sift.detectAndCompute(picture, cv::noArray(), found.points, found.descriptors);
        return found;
    }
    sift.detect(picture, found.points);
    std::erase_if(found.points, [&](const cv::KeyPoint& point) { return is_hidden(point, mask); });
    cv::KeyPointsFilter::retainBest(found.points, max_features);
    if (!found.points.empty()) sift.compute(picture, found.points, found.descriptors);
    return found;
}

}  // namespace

Features detect_sift(const GrayImage& image, const SiftOptions& options, const GrayImage& mask) {
    Features result;
    if (image.empty()) return result;
    // OpenCV takes a non-const pointer but does not write through it.
    const cv::Mat picture(image.height(), image.width(), CV_8UC1,
                          const_cast<std::uint8_t*>(image.pixels().data()));
    constexpr int kLayersPerOctave = 3;
    const int detected = mask.empty() ? options.max_features : 0;  // 0: all.
    const cv::Ptr<cv::SIFT> sift =
        cv::SIFT::create(detected, kLayersPerOctave, options.contrast_threshold);
    const auto [points, descriptors] = described_points(*sift, picture, mask, options.max_features);
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int a, int b) {
        return order_of(points[static_cast<std::size_t>(a)]) <
               order_of(points[static_cast<std::size_t>(b)]);
    });
    // Equally strong ones may be more than asked for.
    if (order.size() > static_cast<std::size_t>(options.max_features)) {
        order.resize(static_cast<std::size_t>(options.max_features));
    }
    for (const int index : order) {
        const cv::KeyPoint& point = points[static_cast<std::size_t>(index)];
        result.keypoints.push_back(
            {{point.pt.x + kOurPixelFromSift, point.pt.y + kOurPixelFromSift}, 0.5F * point.size});
        result.descriptors.push_back(root_sift(descriptors.ptr<float>(index)));
    }
    return result;
}

}  // namespace lumi
