#include "meshing/filling/edge_aware_fill.h"

#include <algorithm>
#include <array>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <span>
#include <vector>

#include "meshing/agreement/seen_past.h"
#include "meshing/filling/guided_smoothing.h"
#include "meshing/filling/plane_slopes.h"

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

/// What remains of a candidate where it is asked for; small, for half of them wait for the rest.
struct Found {
    float inverse_depth = 0.0F;
    float distance_px = 0.0F;  ///< 0: nothing was found.
    bool is_plane = false;
};
using FoundOnOneWay = std::array<Found, kDirections / 2>;

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

Field field_of(const DepthMap& map, SurroundingDepth surrounding, double one_pixel) {
    Field field{std::move(surrounding.map), surrounding.margin_x, surrounding.margin_y, {}};
    if (field.map.confidence.empty()) {
        field.map = map;
    } else {
        for (int y = 0; y < map.confidence.height(); ++y) {
            for (int x = 0; x < map.confidence.width(); ++x) {
                if (map.confidence(x, y) == 0) continue;
                field.map.inverse_depth(x + field.margin_x, y + field.margin_y) =
                    map.inverse_depth(x, y);
                field.map.confidence(x + field.margin_x, y + field.margin_y) = kKnown;
            }
        }
    }
    field.slopes = plane_slopes(field.map, one_pixel);
    forget_shreds_beyond(map, field);
    return field;
}

/// Walks the field once, row by row, and tells what lies in the four directions that it comes from:
/// along the row, and in three directions of the row before. `step` is +1 from the top-left corner,
/// -1 from the bottom-right one.
class DirectionSweep {
 public:
    DirectionSweep(const Field& field, const GrayImage& wanted, int step)
        : field_(field), wanted_(wanted), step_(step) {}

    /// Calls `take(x, y, found)` for each unknown pixel of the picture, in the order of the walk.
    template <class Take>
    void run(const Take& take) {
        const int width = field_.map.confidence.width();
        const int height = field_.map.confidence.height();
        // One more at either end: nothing is known beyond the border.
        Row above(static_cast<std::size_t>(width) + 2);
        Row current = above;
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
                if (wanted_.contains(own_x, own_y)) take(own_x, own_y, found_of(current[at]));
            }
            std::swap(above, current);
        }
    }

 private:
    using Row = std::vector<std::array<Candidate, kDirections / 2>>;

    [[nodiscard]] static FoundOnOneWay found_of(
        const std::array<Candidate, kDirections / 2>& candidates) {
        FoundOnOneWay found;
        std::transform(
            candidates.begin(), candidates.end(), found.begin(),
            [](const Candidate& candidate) -> Found {
                if (!candidate.is_known) return {};
                return {candidate.inverse_depth, candidate.distance_px, candidate.slope.is_plane};
            });
        return found;
    }

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
};

/// The candidate that stands for the background: the farthest, if it lies on a plane or there are
/// but two; else the second farthest, so that one wrong pixel does not rule.
Found background_of(std::span<Found> found) {
    std::sort(found.begin(), found.end(),
              [](const Found& a, const Found& b) { return a.inverse_depth < b.inverse_depth; });
    return found.size() >= 3 && !found[0].is_plane ? found[1] : found[0];
}

/// Mean of the candidates that continue the background.
float background_mean(std::span<Found> found, float one_pixel) {
    // A surface that recedes by a third of a pixel per pixel is still one surface.
    constexpr float kSlope = 0.33F;
    const Found background = background_of(found);
    float sum = 0;
    float weights = 0;
    for (const Found& candidate : found) {
        const float allowed =
            one_pixel * (1 + kSlope * (candidate.distance_px + background.distance_px));
        if (candidate.inverse_depth > background.inverse_depth + allowed) continue;
        sum += candidate.inverse_depth / candidate.distance_px;
        weights += 1 / candidate.distance_px;
    }
    return sum / weights;
}

/// Takes away candidates that do not lie nearer, unless none does.
void keep_what_lies_before(float inverse_depth, std::vector<Found>& found) {
    const auto first_behind = std::partition(
        found.begin(), found.end(),
        [&](const Found& candidate) { return candidate.inverse_depth > inverse_depth; });
    if (first_behind != found.begin()) found.erase(first_behind, found.end());
}

/// Returns how far from what is known the pixels lie that it continues, where it does not lie on
/// most sides of them: 0 for all others.
FloatImage fill_from_background(DepthMap& map, const FloatImage& fallback, float one_pixel,
                                const Field& field, const DepthMap& hidden) {
    constexpr std::size_t kMostOfContinued = kDirections / 2;
    const float clearly = static_cast<float>(kClearlyApartPx) * one_pixel;
    FloatImage continued_px(map.confidence.width(), map.confidence.height(), 0.0F);
    const auto nearer = [](const Found& a, const Found& b) {
        return a.distance_px < b.distance_px;
    };
    for (int y = 0; y < map.confidence.height(); ++y) {
        for (int x = 0; x < map.confidence.width(); ++x) {
            if (!field.is_known(x + field.margin_x, y + field.margin_y)) continue;
            map.inverse_depth(x, y) =
                field.map.inverse_depth(x + field.margin_x, y + field.margin_y);
        }
    }
    std::vector<FoundOnOneWay> found_before;
    const auto& confidence = map.confidence.pixels();
    found_before.reserve(
        static_cast<std::size_t>(std::count(confidence.begin(), confidence.end(), 0)));
    DirectionSweep(field, map.confidence, +1).run([&](int, int, const FoundOnOneWay& found) {
        found_before.push_back(found);
    });
    // The way back meets the same pixels from the last to the first.
    std::vector<Found> around;
    DirectionSweep(field, map.confidence, -1).run([&](int x, int y, const FoundOnOneWay& after) {
        around.assign(found_before.back().begin(), found_before.back().end());
        around.insert(around.end(), after.begin(), after.end());
        found_before.pop_back();
        std::erase_if(around, [](const Found& found) { return found.distance_px <= 0; });
        if (!around.empty() && around.size() <= kMostOfContinued) {
            continued_px(x, y) =
                std::min_element(around.begin(), around.end(), nearer)->distance_px;
        }
        if (hidden.confidence.contains(x, y) && hidden.confidence(x, y) != 0) {
            keep_what_lies_before(hidden.inverse_depth(x, y) + clearly, around);
        }
        map.inverse_depth(x, y) =
            around.empty() ? fallback(x, y) : background_mean(around, one_pixel);
    });
    return continued_px;
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

}  // namespace

FloatImage continue_known_depth(DepthMap& map, const FloatImage& fallback, double one_pixel,
                                SurroundingDepth surrounding, const DepthMap& hidden) {
    const auto& confidence = map.confidence.pixels();
    if (std::find(confidence.begin(), confidence.end(), 0) == confidence.end()) {
        return FloatImage(map.confidence.width(), map.confidence.height(), 0.0F);
    }
    return fill_from_background(map, fallback, static_cast<float>(one_pixel),
                                field_of(map, std::move(surrounding), one_pixel), hidden);
}

void smooth_filled_depth(DepthMap& map, const ColorImage& photograph, double one_pixel) {
    const FloatImage smooth = smooth_guided(
        map.inverse_depth, holds_of(map, static_cast<float>(one_pixel)), photograph, {});
    for (std::size_t i = 0; i < smooth.pixels().size(); ++i) {
        if (map.confidence.pixels()[i] == 0) map.inverse_depth.pixels()[i] = smooth.pixels()[i];
    }
}

}  // namespace lumi
