#include "meshing/transients/counterparts.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// Leaves show other sides to other views.
bool is_alike(const ColorMatch& match, const Rgb8& own, const Rgb8& other) {
    constexpr int kLeastTolerance = 24;
    return largest_difference(own, match.in_own_colors(other)) <=
           std::max(kLeastTolerance, 2 * match.tolerance);
}

/// Nearly the nearest that the view knows.
double nearest_known(const DepthMap& map) {
    constexpr std::size_t kStride = 16;
    constexpr double kNearly = 0.98;
    std::vector<double> known;
    for (std::size_t i = 0; i < map.confidence.pixels().size(); i += kStride) {
        if (map.confidence.pixels()[i] == 0) continue;
        known.push_back(static_cast<double>(map.inverse_depth.pixels()[i]));
    }
    return known.empty() ? 0.0 : quantile_of(std::move(known), kNearly);
}

}  // namespace

PatchColors patch_colors(GrayImage unlike, const ColorImage& picture) {
    const int side_px = 2 * std::max(2, picture.width() / 100) + 1;
    PatchColors result{GrayImage(picture.width(), picture.height()), picture};
    const cv::Mat mask(unlike.height(), unlike.width(), CV_8U, unlike.pixels().data());
    cv::Mat colors(picture.height(), picture.width(), CV_8UC3, result.color.pixels().data());
    cv::Mat kept = cv::Mat::zeros(colors.size(), CV_8UC3);
    colors.copyTo(kept, mask);
    cv::Mat sums;
    cv::boxFilter(kept, sums, CV_32F, {side_px, side_px}, {-1, -1}, false);
    cv::Mat counts;
    cv::boxFilter(mask, counts, CV_32F, {side_px, side_px}, {-1, -1}, false);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const float count = counts.at<float>(y, x) / 255.0F;
            if (count < 1.0F) continue;
            result.is_near(x, y) = 255;
            const auto& sum = sums.at<cv::Vec3f>(y, x);
            result.color(x, y) = {static_cast<std::uint8_t>(sum[0] / count),
                                  static_cast<std::uint8_t>(sum[1] / count),
                                  static_cast<std::uint8_t>(sum[2] / count)};
        }
    }
    return result;
}

Counterparts::Counterparts(const std::vector<KnownView>& views,
                           const std::vector<PatchColors>& patches,
                           const std::vector<Witness>& witnesses, int view_index)
    : patches_(patches),
      witnesses_(witnesses),
      own_(views[static_cast<std::size_t>(view_index)]),
      own_patches_(patches[static_cast<std::size_t>(view_index)]),
      nearest_(2 * nearest_known(own_.known)) {}

bool Counterparts::has(int x, int y) const {
    constexpr double kStep_px = 2.0;
    constexpr int kMostSteps = 400;
    const int steps = std::clamp(
        static_cast<int>(nearest_ * own_.disparity_px_per_inverse_depth / kStep_px), 1, kMostSteps);
    for (int step = 0; step <= steps; ++step) {
        if (has_at(x, y, nearest_ * step / steps)) return true;
    }
    return false;
}

bool Counterparts::has_at(int x, int y, double inverse_depth) const {
    constexpr std::size_t kAsked = 6;
    int in_frame = 0;
    int alike = 0;
    for (std::size_t k = 0; k < std::min(kAsked, witnesses_.size()); ++k) {
        const Witness& witness = witnesses_[k];
        const Eigen::Vector3d at = witness.other_from_own({x + 0.5, y + 0.5}, inverse_depth);
        if (at.z() <= 0) continue;
        const Eigen::Vector2i place = at.hnormalized().array().floor().cast<int>();
        const PatchColors& there = patches_[static_cast<std::size_t>(witness.view)];
        if (!there.is_near.contains(place.x(), place.y())) continue;
        ++in_frame;
        if (there.is_near(place.x(), place.y()) == 0) continue;
        const Rgb8& color = there.color(place.x(), place.y());
        if (is_alike(witness.match, own_patches_.color(x, y), color)) ++alike;
    }
    return alike >= 2 && 2 * alike >= in_frame;
}

}  // namespace lumi
