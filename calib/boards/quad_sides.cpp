#include "calib/boards/quad_sides.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace lumi {
namespace {

using QuadCorners = std::array<Eigen::Vector2d, 4>;

/// Bilinear between pixel centres; the rim continues beyond the picture.
double brightness_at(const GrayImage& picture, const Eigen::Vector2d& px) {
    const double x = std::clamp(px.x() - 0.5, 0.0, picture.width() - 1.001);
    const double y = std::clamp(px.y() - 0.5, 0.0, picture.height() - 1.001);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, picture.width() - 1);
    const int bottom = std::min(top + 1, picture.height() - 1);
    const double across = x - left;
    const double down = y - top;
    return (1 - down) * ((1 - across) * picture(left, top) + across * picture(right, top)) +
           down * ((1 - across) * picture(left, bottom) + across * picture(right, bottom));
}

/// How far outwards of `px` the edge lies, within `reach_px`.
std::optional<double> edge_offset_px(const GrayImage& picture, const Eigen::Vector2d& px,
                                     const Eigen::Vector2d& outwards, double reach_px) {
    constexpr double kStep_px = 0.25;
    constexpr double kHalfBaseline_px = 0.5;
    constexpr double kLeastSlope = 3;  // Grey levels a pixel.
    double steepest = 0;
    double weight_sum = 0;
    double weighted_sum = 0;
    for (double offset = -reach_px; offset <= reach_px; offset += kStep_px) {
        const double slope = brightness_at(picture, px + (offset + kHalfBaseline_px) * outwards) -
                             brightness_at(picture, px + (offset - kHalfBaseline_px) * outwards);
        if (slope <= 0) continue;
        steepest = std::max(steepest, slope);
        weight_sum += slope * slope;
        weighted_sum += slope * slope * offset;
    }
    if (steepest < kLeastSlope) return std::nullopt;
    return weighted_sum / weight_sum;
}

/// Edge offset against distance along a side.
struct EdgeLine {
    double at_start_px = 0.0;
    double slope = 0.0;
};

struct EdgeSample {
    double along_px = 0.0;
    double offset_px = 0.0;
};

EdgeLine line_through(const std::vector<EdgeSample>& samples) {
    double along = 0;
    double offset = 0;
    for (const EdgeSample& sample : samples) {
        along += sample.along_px / static_cast<double>(samples.size());
        offset += sample.offset_px / static_cast<double>(samples.size());
    }
    double square = 0;
    double product = 0;
    for (const EdgeSample& sample : samples) {
        square += (sample.along_px - along) * (sample.along_px - along);
        product += (sample.along_px - along) * (sample.offset_px - offset);
    }
    const double slope = square > 0 ? product / square : 0;
    return {offset - slope * along, slope};
}

/// The line through most of the samples: the worst goes while it lies far from the others' line.
std::optional<EdgeLine> line_through_most(std::vector<EdgeSample> samples) {
    constexpr std::size_t kLeastSamples = 4;
    constexpr double kFar_px = 0.4;
    while (samples.size() >= kLeastSamples) {
        const EdgeLine line = line_through(samples);
        const auto distance = [&](const EdgeSample& sample) {
            return std::abs(sample.offset_px - line.at_start_px - line.slope * sample.along_px);
        };
        const auto worst = std::max_element(
            samples.begin(), samples.end(),
            [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
        if (distance(*worst) <= kFar_px) return line;
        samples.erase(worst);
    }
    return std::nullopt;
}

/// The part of a side next to `corner`, towards `next`: a line in homogeneous coordinates.
std::optional<Eigen::Vector3d> side_near(const GrayImage& picture, const Eigen::Vector2d& corner,
                                         const Eigen::Vector2d& next, const Eigen::Vector2d& centre,
                                         double reach_px) {
    const double length_px = (next - corner).norm();
    const Eigen::Vector2d along = (next - corner) / length_px;
    Eigen::Vector2d outwards(along.y(), -along.x());
    if (outwards.dot(corner - centre) < 0) outwards = -outwards;
    // Sides bend where the lens does: only the nearest part of a long one counts.
    constexpr double kLongest_px = 30;
    const double skipped_px = std::max(2.0, 0.1 * length_px);
    const double end_px = std::min(length_px - skipped_px, skipped_px + kLongest_px);
    std::vector<EdgeSample> samples;
    const double step_px = std::max(0.5, (end_px - skipped_px) / 20);
    for (double at_px = skipped_px; at_px <= end_px; at_px += step_px) {
        const auto offset_px = edge_offset_px(picture, corner + at_px * along, outwards, reach_px);
        if (offset_px) samples.push_back({at_px, *offset_px});
    }
    const auto line = line_through_most(std::move(samples));
    if (!line) return std::nullopt;
    const Eigen::Vector2d start = corner + line->at_start_px * outwards;
    const Eigen::Vector2d end = start + along + line->slope * outwards;
    return start.homogeneous().cross(end.homogeneous());
}

std::optional<QuadCorners> met_once(const GrayImage& picture, const QuadCorners& corners,
                                    double reach_px) {
    const Eigen::Vector2d centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    QuadCorners result;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const auto side =
            side_near(picture, corners[corner], corners[(corner + 1) % 4], centre, reach_px);
        const auto other =
            side_near(picture, corners[corner], corners[(corner + 3) % 4], centre, reach_px);
        if (!side || !other) return std::nullopt;
        result[corner] = Eigen::Vector3d(side->cross(*other)).hnormalized();
        // Also where a side was not found but another edge.
        if (!((result[corner] - corners[corner]).norm() <= 3 * reach_px)) return std::nullopt;
    }
    return result;
}

}  // namespace

std::optional<QuadCorners> corners_where_sides_meet(const GrayImage& picture,
                                                    const QuadCorners& corners_px) {
    double shortest_px = (corners_px[3] - corners_px[0]).norm();
    for (std::size_t corner = 0; corner < 3; ++corner) {
        shortest_px = std::min(shortest_px, (corners_px[corner + 1] - corners_px[corner]).norm());
    }
    constexpr double kShortest_px = 12;
    if (shortest_px < kShortest_px) return std::nullopt;
    // From outlines of a threshold to the edge, then only what blur smears.
    const double first_reach_px = std::clamp(0.08 * shortest_px, 2.0, 5.0);
    std::optional<QuadCorners> corners = met_once(picture, corners_px, first_reach_px);
    constexpr int kRounds = 2;
    for (int round = 0; corners && round < kRounds; ++round) {
        corners = met_once(picture, *corners, std::min(first_reach_px, 3.0));
    }
    return corners;
}

}  // namespace lumi
