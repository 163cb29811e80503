#include "meshing/transients/counterparts.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "calib/work/median.h"
#include "meshing/agreement/seen_past.h"

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
            result.has_unlike(x, y) = 255;
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
    : views_(views),
      patches_(patches),
      witnesses_(witnesses),
      own_(views[static_cast<std::size_t>(view_index)]),
      own_patches_(patches[static_cast<std::size_t>(view_index)]),
      nearest_known_(nearest_known(own_.known)) {}

bool Counterparts::has(int x, int y, double behind) const {
    constexpr double kStep_px = 2.0;
    constexpr double kMostSteps = 400.0;
    const double disparity = own_.disparity_px_per_inverse_depth;
    const double nearest =
        std::max(2 * nearest_known_, 0.5 * std::max(own_.picture.width(), 1) / disparity);
    const int steps = static_cast<int>(std::clamp(nearest * disparity / kStep_px, 1.0, kMostSteps));
    const double before = behind + kClearlyApartPx / disparity;
    for (int step = 0; step <= steps; ++step) {
        const double inverse_depth = nearest * step / steps;
        const bool may_be_unseen = inverse_depth > before && inverse_depth <= nearest_known_;
        if (has_at(x, y, inverse_depth, may_be_unseen)) return true;
    }
    return false;
}

bool Counterparts::has_at(int x, int y, double inverse_depth, bool may_be_unseen) const {
    constexpr std::size_t kAsked = 6;
    const auto asked = static_cast<int>(std::min(kAsked, witnesses_.size()));
    int alike = 0;
    int unlike = 0;
    int hidden = 0;
    for (int k = 0; k < asked; ++k) {
        const Witness& witness = witnesses_[static_cast<std::size_t>(k)];
        const auto other = static_cast<std::size_t>(witness.view);
        const KnownView& view = views_[other];
        const auto place = place_in_view(view.known, witness.other_from_own, x, y,
                                         static_cast<float>(inverse_depth));
        if (!place) continue;
        const PatchColors& there = patches_[other];
        if (there.has_unlike(place->x, place->y) != 0 &&
            is_alike(witness.match, own_patches_.color(x, y), there.color(place->x, place->y))) {
            ++alike;
        } else if (place->ahead * view.disparity_px_per_inverse_depth < -kClearlyApartPx) {
            ++hidden;
        } else {
            ++unlike;
        }
    }
    if (!may_be_unseen) unlike += hidden;
    if (alike >= 2 && alike >= unlike) return true;
    return may_be_unseen && 4 * unlike <= asked;
}

}  // namespace lumi
