#include "meshing/depth_models/pair_stereo.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <span>

#include "calib/capture/gray.h"

namespace lumi {
namespace {

constexpr int kMaxDisparities = 256;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// OpenCV counts pixels from the centre of the first, lumi from its corner.
cv::Mat opencv_calibration(const Camera& camera) {
    const Eigen::Vector2d focal = focal_length_px(camera);
    const Eigen::Vector2d centre = principal_point_px(camera);
    return (cv::Mat_<double>(3, 3) << focal.x(), 0, centre.x() - 0.5, 0, focal.y(),
            centre.y() - 0.5, 0, 0, 1);
}

cv::Mat to_cv(const Eigen::Matrix3d& matrix) {
    cv::Mat result(3, 3, CV_64F);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            result.at<double>(row, column) = matrix(row, column);
        }
    }
    return result;
}

/// A pair whose corresponding points lie on one row, or on one column when the second camera
/// stands above or below the first.
struct RectifiedPair {
    cv::Mat calibration[2];
    cv::Mat rotation[2];    ///< rectified_from_cam.
    cv::Mat projection[2];  ///< 3x4.
    cv::Size size;
    bool is_vertical = false;

    /// Along the row (column): position in the first minus position in the second, of a point at an
    /// inverse depth along the rectified axis.
    [[nodiscard]] double disparity(double inverse_depth) const {
        return offset() - shift() * inverse_depth;
    }
    [[nodiscard]] double inverse_depth(double disparity_px) const {
        return (offset() - disparity_px) / shift();
    }

 private:
    [[nodiscard]] double offset() const {
        const int axis = is_vertical ? 1 : 0;
        return projection[0].at<double>(axis, 2) - projection[1].at<double>(axis, 2);
    }
    [[nodiscard]] double shift() const { return projection[1].at<double>(is_vertical ? 1 : 0, 3); }
};

/// True when b's centre, or the point opposite of it, lies in a's picture or near it.
bool epipole_is_near(const Camera& camera_a, const Eigen::Vector3d& centre_of_b_in_a) {
    constexpr double kMargin = 0.25;  // Of the picture's size.
    if (std::abs(centre_of_b_in_a.z()) < 1e-9 * centre_of_b_in_a.norm()) return false;
    const Eigen::Vector2d focal = focal_length_px(camera_a);
    const Eigen::Vector2d pixel =
        centre_of_b_in_a.hnormalized().cwiseProduct(focal) + principal_point_px(camera_a);
    return pixel.x() > -kMargin * camera_a.width_px &&
           pixel.x() < (1 + kMargin) * camera_a.width_px &&
           pixel.y() > -kMargin * camera_a.height_px &&
           pixel.y() < (1 + kMargin) * camera_a.height_px;
}

std::optional<RectifiedPair> rectify(const DepthView& a, const DepthView& b) {
    constexpr double kMaxAngleRad = std::numbers::pi / 3;
    const Rigid3 b_from_a = b.cam_from_world * inverse(a.cam_from_world);
    if (b_from_a.translation.norm() <= 0) return std::nullopt;
    if (Eigen::AngleAxisd(b_from_a.rotation).angle() > kMaxAngleRad) return std::nullopt;
    if (epipole_is_near(a.camera, inverse(b_from_a).translation) ||
        epipole_is_near(b.camera, b_from_a.translation)) {
        return std::nullopt;
    }
    RectifiedPair pair;
    pair.calibration[0] = opencv_calibration(a.camera);
    pair.calibration[1] = opencv_calibration(b.camera);
    pair.size = cv::Size(a.camera.width_px, a.camera.height_px);
    const cv::Mat no_distortion = cv::Mat::zeros(1, 5, CV_64F);
    const cv::Mat translation = (cv::Mat_<double>(3, 1) << b_from_a.translation.x(),
                                 b_from_a.translation.y(), b_from_a.translation.z());
    cv::Mat disparity_to_depth;
    cv::stereoRectify(pair.calibration[0], no_distortion, pair.calibration[1], no_distortion,
                      pair.size, to_cv(b_from_a.rotation.toRotationMatrix()), translation,
                      pair.rotation[0], pair.rotation[1], pair.projection[0], pair.projection[1],
                      disparity_to_depth, 0, -1);
    pair.is_vertical = std::abs(pair.projection[1].at<double>(1, 3)) >
                       std::abs(pair.projection[1].at<double>(0, 3));
    return pair;
}

/// The view's pixel as a point of the rectified picture, and how much of the rectified depth one
/// unit of the view's depth is.
struct RectifiedPixel {
    double x = 0;
    double y = 0;
    double depth_share = 0;
};

class PixelRectification {
 public:
    explicit PixelRectification(const RectifiedPair& pair) {
        const cv::Mat ray = pair.rotation[0] * pair.calibration[0].inv();
        const cv::Mat pixel = pair.projection[0].colRange(0, 3) * ray;
        for (int column = 0; column < 3; ++column) {
            for (int row = 0; row < 3; ++row) pixel_(row, column) = pixel.at<double>(row, column);
            depth_(column) = ray.at<double>(2, column);
        }
    }
    [[nodiscard]] RectifiedPixel operator()(double x, double y) const {
        const Eigen::Vector3d source(x, y, 1);
        const Eigen::Vector3d target = pixel_ * source;
        return {target.x() / target.z(), target.y() / target.z(), depth_.dot(source)};
    }

 private:
    Eigen::Matrix3d pixel_;
    Eigen::RowVector3d depth_;
};

struct DisparityRange {
    int first = 0;
    int count = 0;
};

/// The disparities of the view's range, over its whole picture, as far as pictures of this size can
/// show them.
DisparityRange disparities_of(const DepthView& view, const RectifiedPair& pair) {
    const PixelRectification rectified(pair);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double x : {0.0, 0.5, 1.0}) {
        for (const double y : {0.0, 0.5, 1.0}) {
            const RectifiedPixel pixel =
                rectified(x * view.camera.width_px, y * view.camera.height_px);
            if (pixel.depth_share <= 0) continue;
            for (const double inverse_depth : {view.range.far, view.range.near}) {
                const double disparity = pair.disparity(inverse_depth / pixel.depth_share);
                low = std::min(low, disparity);
                high = std::max(high, disparity);
            }
        }
    }
    if (!(low <= high)) return {};
    const double most = pair.is_vertical ? pair.size.height : pair.size.width;
    const int first = static_cast<int>(std::floor(std::clamp(low, -most, most))) - 1;
    const int needed = static_cast<int>(std::ceil(std::clamp(high, -most, most))) + 2 - first;
    return {first, (needed + 15) / 16 * 16};
}

cv::Mat rectified_gray(const DepthView& view, const RectifiedPair& pair, int which) {
    GrayImage gray = gray_of(view.photograph);
    const cv::Mat source(gray.height(), gray.width(), CV_8U, gray.pixels().data());
    cv::Mat map_x, map_y, target;
    cv::initUndistortRectifyMap(pair.calibration[which], cv::noArray(), pair.rotation[which],
                                pair.projection[which].colRange(0, 3), pair.size, CV_32F, map_x,
                                map_y);
    cv::remap(source, target, map_x, map_y, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    return target;
}

/// Disparities of the first rectified picture; NaN where unknown.
cv::Mat matched(const DepthView& a, const DepthView& b, const RectifiedPair& pair,
                DisparityRange range) {
    constexpr int kWindow = 5;
    constexpr int kFixedPoint = cv::StereoMatcher::DISP_SCALE;
    cv::Mat first = rectified_gray(a, pair, 0);
    cv::Mat second = rectified_gray(b, pair, 1);
    if (pair.is_vertical) {
        first = first.t();
        second = second.t();
    }
    double shrink = 1;
    for (; range.count > kMaxDisparities; shrink *= 2) {
        range = {static_cast<int>(std::floor(range.first / 2.0)), (range.count / 2 + 31) / 16 * 16};
    }
    if (shrink > 1) {
        cv::resize(first, first, {}, 1 / shrink, 1 / shrink, cv::INTER_AREA);
        cv::resize(second, second, first.size(), 0, 0, cv::INTER_AREA);
    }
    const auto matcher = cv::StereoSGBM::create(range.first, range.count, kWindow,
                                                8 * kWindow * kWindow, 32 * kWindow * kWindow, 1,
                                                63, 10, 100, 2, cv::StereoSGBM::MODE_SGBM);
    cv::Mat fixed, disparity;
    matcher->compute(first, second, fixed);
    fixed.convertTo(disparity, CV_32F, shrink / kFixedPoint);
    disparity.setTo(kUnknown, fixed < range.first * kFixedPoint);
    return pair.is_vertical ? cv::Mat(disparity.t()) : disparity;
}

/// The view's inverse depths by one pair; NaN where unknown.
FloatImage inverse_depths_by(const DepthView& view, const DepthView& other,
                             const RectifiedPair& pair) {
    FloatImage result(view.camera.width_px, view.camera.height_px, kUnknown);
    const DisparityRange range = disparities_of(view, pair);
    if (range.count == 0) return result;
    const cv::Mat disparity = matched(view, other, pair, range);
    const double scale = static_cast<double>(disparity.cols) / pair.size.width;
    const PixelRectification rectified(pair);
    for (int y = 0; y < result.height(); ++y) {
        for (int x = 0; x < result.width(); ++x) {
            const RectifiedPixel pixel = rectified(x, y);
            const double column = std::floor(scale * (pixel.x + 0.5));
            const double row = std::floor(scale * (pixel.y + 0.5));
            if (!(column >= 0 && row >= 0 && column < disparity.cols && row < disparity.rows)) {
                continue;
            }
            const float found =
                disparity.at<float>(static_cast<int>(row), static_cast<int>(column));
            if (std::isnan(found) || pixel.depth_share <= 0) continue;
            const double inverse_depth =
                pair.inverse_depth(static_cast<double>(found)) * pixel.depth_share;
            result(x, y) = static_cast<float>(std::max(0.0, inverse_depth));
        }
    }
    return result;
}

/// Mean of the largest group within `one_pixel` of one of its members; the nearer of two equal
/// ones.
struct Fused {
    float inverse_depth = 0.0F;
    int support = 0;
};
Fused fused(std::span<const float> said, float one_pixel) {
    Fused best;
    for (const float centre : said) {
        Fused group;
        for (const float value : said) {
            if (std::abs(value - centre) > one_pixel) continue;
            group.inverse_depth += value;
            ++group.support;
        }
        if (group.support == 0) continue;
        group.inverse_depth /= static_cast<float>(group.support);
        if (group.support > best.support ||
            (group.support == best.support && group.inverse_depth > best.inverse_depth)) {
            best = group;
        }
    }
    return best;
}

}  // namespace

int rectifiable_pairs(const DepthScene& scene, int view_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    return static_cast<int>(
        std::count_if(view.neighbours.begin(), view.neighbours.end(), [&](int j) {
            return rectify(view, scene.views[static_cast<std::size_t>(j)]).has_value();
        }));
}

DepthMap pair_stereo(const DepthScene& scene, int view_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    std::vector<FloatImage> by_pair;
    for (const int j : view.neighbours) {
        const DepthView& other = scene.views[static_cast<std::size_t>(j)];
        if (const auto pair = rectify(view, other)) {
            by_pair.push_back(inverse_depths_by(view, other, *pair));
        }
    }
    DepthMap map{FloatImage(view.camera.width_px, view.camera.height_px),
                 GrayImage(view.camera.width_px, view.camera.height_px)};
    const auto one_pixel = static_cast<float>(1.0 / view.disparity_px_per_inverse_depth);
    std::vector<float> said;
    for (std::size_t i = 0; i < map.inverse_depth.pixels().size(); ++i) {
        said.clear();
        for (const FloatImage& image : by_pair) {
            if (!std::isnan(image.pixels()[i])) said.push_back(image.pixels()[i]);
        }
        const Fused result = fused(said, one_pixel);
        map.inverse_depth.pixels()[i] = result.inverse_depth;
        map.confidence.pixels()[i] = confidence_of_support(result.support);
    }
    return map;
}

}  // namespace lumi
