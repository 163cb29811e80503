#include "meshing/depth/edge_aware_fill.h"

#include <algorithm>
#include <array>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <span>
#include <vector>

#include "meshing/depth/guided_smoothing.h"
#include "meshing/depth/plane_slopes.h"

namespace lumi {
namespace {

constexpr std::size_t kDirections = 8;

/// The nearest known pixel in one direction, and the plane through it continued to this one.
struct Candidate {
    float inverse_depth = 0.0F;  ///< Of the plane, here.
    PlaneSlopes::Slope slope;
    float distance_px = 0.0F;
    bool is_known = false;
};

/// What each unknown pixel finds, in the order of the pixels.
using CandidatesOfPixel = std::array<Candidate, kDirections>;

/// The map within what is known around it.
struct Field {
    DepthMap map;
    int margin_x = 0;
    int margin_y = 0;
    PlaneSlopes slopes;

    [[nodiscard]] bool is_known(int x, int y) const { return map.confidence(x, y) != 0; }
};

/// Beyond the picture only planes count: what other views saw aslant is in shreds.
void forget_shreds_beyond(const DepthMap& map, Field& field) {
    for (int y = 0; y < field.map.confidence.height(); ++y) {
        for (int x = 0; x < field.map.confidence.width(); ++x) {
            if (map.confidence.contains(x - field.margin_x, y - field.margin_y)) continue;
            if (!field.slopes.at(x, y).is_plane) field.map.confidence(x, y) = 0;
        }
    }
}

Field field_of(const DepthMap& map, const SurroundingDepth& surrounding, double one_pixel) {
    Field field{surrounding.map, surrounding.margin_x, surrounding.margin_y, {}};
    if (field.map.confidence.empty()) {
        field.map = map;
    } else {
        for (int y = 0; y < map.confidence.height(); ++y) {
            for (int x = 0; x < map.confidence.width(); ++x) {
                if (map.confidence(x, y) == 0) continue;
                field.map.inverse_depth(x + field.margin_x, y + field.margin_y) =
                    map.inverse_depth(x, y);
                field.map.confidence(x + field.margin_x, y + field.margin_y) = 255;
            }
        }
    }
    field.slopes = plane_slopes(field.map, one_pixel);
    forget_shreds_beyond(map, field);
    return field;
}

/// Walks the field once, row by row, and notes what lies in the four directions that it comes from:
/// along the row, and in three directions of the row before. `step` is +1 from the top-left corner,
/// -1 from the bottom-right one.
class DirectionSweep {
 public:
    DirectionSweep(const Field& field, const GrayImage& wanted, int step)
        : field_(field), wanted_(wanted), step_(step), begin_(step > 0 ? 0 : kDirections / 2) {}

    void run(std::vector<CandidatesOfPixel>& candidates) {
        const int width = field_.map.confidence.width();
        const int height = field_.map.confidence.height();
        // One more at either end: nothing is known beyond the border.
        Row above(static_cast<std::size_t>(width) + 2);
        Row current = above;
        std::size_t next = step_ > 0 ? 0 : candidates.size() - 1;
        for (int row = 0; row < height; ++row) {
            const int y = step_ > 0 ? row : height - 1 - row;
            for (int column = 0; column < width; ++column) {
                const int x = step_ > 0 ? column : width - 1 - column;
                const auto at = static_cast<std::size_t>(x) + 1;
                if (field_.is_known(x, y)) {
                    current[at].fill(
                        {field_.map.inverse_depth(x, y), field_.slopes.at(x, y), 0.0F, true});
                    continue;
                }
                current[at] = continued(above, current, at);
                const int own_x = x - field_.margin_x;
                const int own_y = y - field_.margin_y;
                if (!wanted_.contains(own_x, own_y)) continue;
                for (std::size_t d = 0; d < current[at].size(); ++d) {
                    candidates[next][begin_ + d] = current[at][d];
                }
                next += step_ > 0 ? 1 : std::size_t(-1);
            }
            std::swap(above, current);
        }
    }

 private:
    using Row = std::vector<std::array<Candidate, kDirections / 2>>;

    /// Along the row, then the three of the row before.
    [[nodiscard]] std::array<Candidate, kDirections / 2> continued(const Row& above,
                                                                   const Row& current,
                                                                   std::size_t at) const {
        const std::size_t behind = step_ > 0 ? at - 1 : at + 1;
        const std::size_t ahead = step_ > 0 ? at + 1 : at - 1;
        return {farther(current[behind][0], 1, 0), farther(above[behind][1], 1, 1),
                farther(above[at][2], 0, 1), farther(above[ahead][3], -1, 1)};
    }

    /// A candidate one pixel on, in the direction of the walk.
    [[nodiscard]] Candidate farther(Candidate candidate, int dx, int dy) const {
        constexpr float kDiagonal = 1.41421356F;
        constexpr float kReachPx = 160.0F;  // Farther, a plane is not to be trusted.
        if (!candidate.is_known) return candidate;
        candidate.distance_px += dx != 0 && dy != 0 ? kDiagonal : 1.0F;
        if (candidate.distance_px <= kReachPx) {
            const float change = candidate.slope.per_pixel.x() * static_cast<float>(dx * step_) +
                                 candidate.slope.per_pixel.y() * static_cast<float>(dy * step_);
            candidate.inverse_depth = std::max(0.0F, candidate.inverse_depth + change);
        }
        return candidate;
    }

    const Field& field_;
    const GrayImage& wanted_;
    int step_;
    std::size_t begin_;
};

/// The candidate that stands for the background: the farthest, if it lies on a plane or there are
/// but two; else the second farthest, so that one wrong pixel does not rule.
Candidate background_of(std::span<Candidate> found) {
    std::sort(found.begin(), found.end(), [](const Candidate& a, const Candidate& b) {
        return a.inverse_depth < b.inverse_depth;
    });
    return found.size() >= 3 && !found[0].slope.is_plane ? found[1] : found[0];
}

/// Mean of the candidates that continue the background.
float background_mean(std::span<Candidate> found, float one_pixel) {
    // A surface that recedes by a third of a pixel per pixel is still one surface.
    constexpr float kSlope = 0.33F;
    const Candidate background = background_of(found);
    float sum = 0;
    float weights = 0;
    for (const Candidate& candidate : found) {
        const float allowed =
            one_pixel * (1 + kSlope * (candidate.distance_px + background.distance_px));
        if (candidate.inverse_depth > background.inverse_depth + allowed) continue;
        sum += candidate.inverse_depth / candidate.distance_px;
        weights += 1 / candidate.distance_px;
    }
    return sum / weights;
}

void fill_from_background(DepthMap& map, const FloatImage& fallback, float one_pixel,
                          const Field& field) {
    std::vector<std::size_t> unknown;
    for (int y = 0; y < map.confidence.height(); ++y) {
        for (int x = 0; x < map.confidence.width(); ++x) {
            if (field.is_known(x + field.margin_x, y + field.margin_y)) {
                map.inverse_depth(x, y) =
                    field.map.inverse_depth(x + field.margin_x, y + field.margin_y);
            } else {
                unknown.push_back(static_cast<std::size_t>(y * map.confidence.width() + x));
            }
        }
    }
    std::vector<CandidatesOfPixel> candidates(unknown.size());
    DirectionSweep(field, map.confidence, +1).run(candidates);
    DirectionSweep(field, map.confidence, -1).run(candidates);
    for (std::size_t k = 0; k < unknown.size(); ++k) {
        const auto end =
            std::remove_if(candidates[k].begin(), candidates[k].end(),
                           [](const Candidate& candidate) { return !candidate.is_known; });
        const std::span found(candidates[k].begin(), end);
        map.inverse_depth.pixels()[unknown[k]] =
            found.empty() ? fallback.pixels()[unknown[k]] : background_mean(found, one_pixel);
    }
}

/// How strongly each pixel holds its place. What is known holds, but not at the edge of a nearer
/// surface: there a matching window has carried its depth too far, into what was filled.
FloatImage holds_of(const DepthMap& map, float one_pixel) {
    constexpr float kFilledWeight = 0.1F;
    constexpr int kWindowRadius = 4;
    constexpr float kNearerPx = 3.0F;
    FloatImage farthest_filled = map.inverse_depth;
    for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] == 0) continue;
        farthest_filled.pixels()[i] = std::numeric_limits<float>::max();
    }
    cv::Mat field(farthest_filled.height(), farthest_filled.width(), CV_32F,
                  farthest_filled.pixels().data());
    cv::erode(field, field, cv::Mat::ones(2 * kWindowRadius + 1, 2 * kWindowRadius + 1, CV_8U));
    FloatImage holds(map.confidence.width(), map.confidence.height(), kFilledWeight);
    for (std::size_t i = 0; i < map.confidence.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] == 0) continue;
        const bool is_edge =
            map.inverse_depth.pixels()[i] > farthest_filled.pixels()[i] + kNearerPx * one_pixel;
        holds.pixels()[i] = is_edge ? 0.0F : 1.0F;
    }
    return holds;
}

/// Smooths what was filled along the photograph's edges.
void smooth_filled(DepthMap& map, const ColorImage& photograph, float one_pixel) {
    const FloatImage smooth =
        smooth_guided(map.inverse_depth, holds_of(map, one_pixel), photograph, {});
    for (std::size_t i = 0; i < smooth.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] == 0) map.inverse_depth.pixels()[i] = smooth.pixels()[i];
    }
}

}  // namespace

void edge_aware_fill(DepthMap& map, const ColorImage& photograph, const FloatImage& fallback,
                     double one_pixel, const SurroundingDepth& surrounding) {
    const auto& confidence = map.confidence.pixels();
    if (std::find(confidence.begin(), confidence.end(), 0) == confidence.end()) return;
    fill_from_background(map, fallback, static_cast<float>(one_pixel),
                         field_of(map, surrounding, one_pixel));
    smooth_filled(map, photograph, static_cast<float>(one_pixel));
}

}  // namespace lumi
