#include "calib/boards/chessboard_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "calib/boards/saddle_points.h"
#include "calib/opencv/opencv_picture.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr std::size_t kLeastCorners = 9;

GrayImage scaled(const GrayImage& picture, double scale) {
    GrayImage result(std::max(1, static_cast<int>(std::lround(picture.width() * scale))),
                     std::max(1, static_cast<int>(std::lround(picture.height() * scale))));
    cv::Mat out = opencv_view(result);
    cv::resize(opencv_view(picture), out, out.size(), 0, 0,
               scale < 1 ? cv::INTER_AREA : cv::INTER_CUBIC);
    return result;
}

/// Saddle points of a picture and which of them may be neighbours on a chessboard.
class ChessboardLinks {
 public:
    ChessboardLinks(const GrayImage& picture, const std::vector<SaddlePoint>& saddles)
        : picture_(picture), saddles_(saddles) {}

    bool may_link(std::size_t from, std::size_t to, int columns, int rows) const {
        const SaddlePoint& a = saddles_[from];
        const SaddlePoint& b = saddles_[to];
        const bool is_odd = (columns + rows) % 2 != 0;
        // Bright and dark quarters change places from each corner to the next.
        const double agreement = a.bright_axis.dot(b.bright_axis) * (is_odd ? -1 : 1);
        constexpr double kLeastAgreement = 0.3;
        if (agreement < kLeastAgreement) return false;
        // The same print under light that changes slowly.
        constexpr double kMaxContrastRatio = 4.0;
        if (std::max(a.contrast, b.contrast) >
            kMaxContrastRatio * std::min(a.contrast, b.contrast)) {
            return false;
        }
        const bool is_unit_step = std::abs(columns) + std::abs(rows) == 1;
        return !is_unit_step || has_edge_between(a, b);
    }

 private:
    int value_at(const Eigen::Vector2d& px) const {
        const int x = static_cast<int>(std::floor(px.x()));
        const int y = static_cast<int>(std::floor(px.y()));
        return picture_.contains(x, y) ? picture_(x, y) : -1;
    }

    /// One side of the way is brighter than the other all along it.
    bool has_edge_between(const SaddlePoint& a, const SaddlePoint& b) const {
        const Eigen::Vector2d way = b.px - a.px;
        const double length_px = way.norm();
        const Eigen::Vector2d sideways = Eigen::Vector2d(-way.y(), way.x()) / length_px;
        const double offset_px = std::max(1.5, 0.08 * length_px);
        const double least = 0.2 * std::min(a.contrast, b.contrast);
        int sign = 0;
        for (const double along : {0.25, 0.4, 0.5, 0.6, 0.75}) {
            const Eigen::Vector2d at = a.px + along * way;
            const int left = value_at(at - offset_px * sideways);
            const int right = value_at(at + offset_px * sideways);
            if (left < 0 || right < 0 || std::abs(left - right) < least) return false;
            const int sign_here = left > right ? 1 : -1;
            if (sign != 0 && sign != sign_here) return false;
            sign = sign_here;
        }
        return true;
    }

    const GrayImage& picture_;
    const std::vector<SaddlePoint>& saddles_;
};

struct ScaledPattern {
    Lattice lattice;
    std::vector<Eigen::Vector2d> points_px;  ///< In the photograph.
    std::size_t candidates = 0;
};

ScaledPattern find_at_scale(const GrayImage& picture, double scale) {
    const GrayImage picture_at_scale = scale == 1 ? picture : scaled(picture, scale);
    const std::vector<SaddlePoint> saddles = detect_saddle_points(picture_at_scale);
    std::vector<Eigen::Vector2d> points_px;
    for (const SaddlePoint& saddle : saddles) points_px.push_back(saddle.px);
    const PointGrid grid(points_px);
    const ChessboardLinks links(picture_at_scale, saddles);
    const LinkTest may_link = [&](std::size_t from, std::size_t to, int columns, int rows) {
        return links.may_link(from, to, columns, rows);
    };
    ScaledPattern found;
    found.candidates = saddles.size();
    found.lattice = largest_lattice(
        grid, may_link, {.tolerance = 0.4, .min_nodes = static_cast<int>(kLeastCorners)});
    const Eigen::Vector2d size_ratio(
        static_cast<double>(picture.width()) / picture_at_scale.width(),
        static_cast<double>(picture.height()) / picture_at_scale.height());
    for (const Eigen::Vector2d& px : points_px) {
        found.points_px.push_back(px.cwiseProduct(size_ratio));
    }
    return found;
}

double smaller_step_px(const LatticePrediction& local) {
    return std::min(local.column_step_px.norm(), local.row_step_px.norm());
}

double median_step_px(const ScaledPattern& found) {
    std::vector<double> steps_px;
    for (const auto& [cell, point] : found.lattice) {
        const auto local = fit_around(found.lattice, found.points_px, cell);
        if (local) steps_px.push_back(smaller_step_px(*local));
    }
    return median_of(std::move(steps_px));
}

/// The scale that shows the most of the board; finer and coarser ones only where they may help.
ScaledPattern find_at_best_scale(const GrayImage& picture) {
    constexpr double kLongSideAtFirst_px = 1400;
    const double first =
        std::min(1.0, kLongSideAtFirst_px / std::max(picture.width(), picture.height()));
    ScaledPattern best = find_at_scale(picture, first);
    const auto try_scale = [&](double scale) {
        ScaledPattern found = find_at_scale(picture, scale);
        if (found.lattice.size() > best.lattice.size()) best = std::move(found);
    };
    // Corners that are blurred over more than the ring's radius.
    try_scale(first / 2);
    if (best.lattice.empty()) try_scale(first / 4);
    constexpr double kFewPixels = 18;
    if (best.lattice.empty() || median_step_px(best) * first < kFewPixels) try_scale(first * 2);
    return best;
}

cv::Point2f refined(const cv::Mat& picture, const cv::Point2f& corner, int half_window_px) {
    std::vector<cv::Point2f> corners{corner};
    cv::cornerSubPix(picture, corners, {half_window_px, half_window_px}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-3});
    return corners.front();
}

/// Corners where the gradients around them are at right angles to the way there (Foerstner and
/// Guelch 1987, as OpenCV does it), first in a window that bridges the error of the coarse scale.
std::vector<PatternNode> refine(const GrayImage& picture, const ScaledPattern& found,
                                double window_share) {
    std::vector<PatternNode> nodes;
    const cv::Mat view = opencv_view(picture);
    for (const auto& [cell, point] : found.lattice) {
        const auto local = fit_around(found.lattice, found.points_px, cell);
        if (!local) continue;
        const double step_px = smaller_step_px(*local);
        const int half_window_px =
            std::clamp(static_cast<int>(std::lround(window_share * step_px)), 2, 14);
        const Eigen::Vector2d start_px = found.points_px[point];
        const Eigen::Vector2d corner_px =
            from_opencv(refined(view, to_opencv(start_px), half_window_px));
        const double moved_px = (corner_px - start_px).norm();
        constexpr double kFarthestShare = 0.2;
        if (!(moved_px <= std::max(1.5, kFarthestShare * step_px))) continue;
        nodes.push_back({cell, corner_px, {}});
    }
    return nodes;
}

/// `window_share`: of the refinement's window, in the step between corners.
ChessboardPattern chessboard_refined_within(const GrayImage& picture, double window_share) {
    ChessboardPattern pattern;
    const ScaledPattern found = find_at_best_scale(picture);
    pattern.candidates = found.candidates;
    if (found.lattice.size() < kLeastCorners) return pattern;
    const LatticeExtent extent = extent_of(found.lattice);
    if (extent.columns() < 3 || extent.rows() < 3) return pattern;
    pattern.median_step_px = median_step_px(found);
    pattern.nodes = refine(picture, found, window_share);
    return pattern;
}

}  // namespace

ChessboardPattern find_chessboard(const GrayImage& picture) {
    constexpr double kWindowShare = 0.25;
    return chessboard_refined_within(picture, kWindowShare);
}

ChessboardPattern find_chessboard_with_markers(const GrayImage& picture) {
    constexpr double kWindowShareBesideMarkers = 0.12;
    return chessboard_refined_within(picture, kWindowShareBesideMarkers);
}

}  // namespace lumi
