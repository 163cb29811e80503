#include "meshing/depth_models/patch_match.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/capture/gray.h"
#include "calib/work/median.h"
#include "meshing/agreement/cross_view_check.h"
#include "meshing/matching/window_match.h"
#include "meshing/surface/depth_map.h"
#include "meshing/warp/pixel_in_picture.h"
#include "meshing/warp/round_trip.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxViews = 32;
constexpr float kMaxCost = 2.0F;
constexpr float kCorrelates = 0.5F;  // Less.

/// A number from -1 to 1 that depends on its arguments alone.
float hashed(std::uint32_t pixel, std::uint32_t iteration, std::uint32_t channel) {
    std::uint32_t h = pixel * 0x9E3779B1U ^ (iteration * 8 + channel + 1) * 0x85EBCA77U;
    h = (h ^ (h >> 15)) * 0x2C1B3C6DU;
    h = (h ^ (h >> 12)) * 0x297A2D39U;
    h ^= h >> 15;
    return static_cast<float>(h >> 8) / 8388608.0F - 1.0F;
}

/// Another view's estimate, to ask whether it agrees.
struct OtherEstimate {
    RoundTrip trip;
    const DepthMap* map;
};

/// One view at work.
class Refinement {
 public:
    Refinement(const DepthScene& scene, const std::vector<DepthEstimate>& estimates, int view_index,
               const PatchMatchOptions& options)
        : view_(scene.views[static_cast<std::size_t>(view_index)]),
          own_(estimates[static_cast<std::size_t>(view_index)].map),
          options_(options),
          gray_(gray_of(view_.photograph)),
          width_(gray_.width()),
          height_(gray_.height()),
          one_pixel_(static_cast<float>(1.0 / view_.disparity_px_per_inverse_depth)) {
        for (const int j : view_.neighbours) {
            if (views_.size() == kMaxViews) break;
            const DepthView& other = scene.views[static_cast<std::size_t>(j)];
            const RoundTrip trip = round_trip(view_, other);
            views_.push_back(compared_view(trip.there, gray_of(other.photograph)));
            estimates_.push_back({trip, &estimates[static_cast<std::size_t>(j)].map});
        }
        begin_with(own_.inverse_depth);
        is_settled_ = GrayImage(width_, height_, 0);
        if (options.only_where_unsure) settle(cross_view_check(scene, estimates, view_index));
    }

    void sweep(int iteration) {
        const int step = iteration % 2 == 0 ? 1 : -1;
        for (int row = 0; row < height_; ++row) {
            const int y = step > 0 ? row : height_ - 1 - row;
            for (int column = 0; column < width_; ++column) {
                const int x = step > 0 ? column : width_ - 1 - column;
                if (is_settled_(x, y) != 0) continue;
                const ReferenceWindow window = reference_window(gray_, x, y);
                if (!window.has_texture) continue;
                const float before = costs_(x, y);
                propagate(window, x, y, iteration);
                vary(window, x, y, iteration);
                if (costs_(x, y) < before) last_change_(x, y) = stamp_of(iteration);
            }
        }
    }

    [[nodiscard]] DepthMap result() const {
        DepthMap map{FloatImage(width_, height_), GrayImage(width_, height_)};
        const bool believes_claims = claims_mostly_correlate();
        for (std::size_t i = 0; i < planes_.pixels().size(); ++i) {
            const bool correlates = costs_.pixels()[i] < kCorrelates;
            const bool is_claimed = believes_claims && own_.confidence.pixels()[i] != 0;
            map.inverse_depth.pixels()[i] = !correlates && is_claimed
                                                ? own_.inverse_depth.pixels()[i]
                                                : planes_.pixels()[i].inverse_depth;
            map.confidence.pixels()[i] = correlates || is_claimed ? kKnown : kUnseen;
        }
        return map;
    }

 private:
    /// Planes through the surface that was found: by the smaller of the differences to either side,
    /// so that a plane does not lean over a step.
    void begin_with(const FloatImage& found) {
        planes_ = Image<PixelPlane>(width_, height_);
        costs_ = FloatImage(width_, height_);
        last_change_ = GrayImage(width_, height_, 0);
        const auto slope = [&](int x, int y, int dx, int dy) {
            const float behind =
                found.contains(x - dx, y - dy) ? found(x, y) - found(x - dx, y - dy) : 1e30F;
            const float ahead =
                found.contains(x + dx, y + dy) ? found(x + dx, y + dy) - found(x, y) : 1e30F;
            const float smaller = std::abs(behind) < std::abs(ahead) ? behind : ahead;
            return std::abs(smaller) <= one_pixel_ ? smaller / static_cast<float>(dx + dy) : 0.0F;
        };
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                planes_(x, y) = {found(x, y), slope(x, y, 2, 0), slope(x, y, 0, 2)};
                const ReferenceWindow window = reference_window(gray_, x, y);
                costs_(x, y) = window.has_texture ? cost(window, x, y, planes_(x, y)) : kMaxCost;
            }
        }
    }

    void settle(const DepthMap& checked) {
        std::vector<std::size_t> confirmed;
        std::vector<double> costs;
        for (std::size_t i = 0; i < costs_.pixels().size(); ++i) {
            if (checked.confidence.pixels()[i] != kConfirmedBySeveral) continue;
            if (costs_.pixels()[i] >= kMaxCost) continue;
            confirmed.push_back(i);
            costs.push_back(static_cast<double>(costs_.pixels()[i]));
        }
        const float enough = settling_cost(static_cast<float>(median_of(std::move(costs))));
        for (const std::size_t i : confirmed) {
            if (costs_.pixels()[i] < enough) is_settled_.pixels()[i] = 1;
        }
    }

    /// What a confirmed pixel may cost without anything to gain: as much as photographs like these
    /// differ where depth is right. Of clean ones a window that costs a tenth shows another
    /// surface; of noisy or glossy ones most cost that much.
    [[nodiscard]] static float settling_cost(float median_of_confirmed) {
        constexpr float kLikeTheOthers = 3.0F;
        constexpr float kAlwaysEnough = 0.05F;
        constexpr float kCorrelatesWell = 0.25F;
        return std::clamp(kLikeTheOthers * median_of_confirmed, kAlwaysEnough, kCorrelatesWell);
    }

    /// Where they do not, the photographs are noise to these windows, and chance to the estimate.
    [[nodiscard]] bool claims_mostly_correlate() const {
        std::size_t claims = 0;
        std::size_t correlating = 0;
        for (std::size_t i = 0; i < costs_.pixels().size(); ++i) {
            if (own_.confidence.pixels()[i] == 0 || costs_.pixels()[i] >= kMaxCost) continue;
            ++claims;
            if (costs_.pixels()[i] < kCorrelates) ++correlating;
        }
        return 2 * correlating >= claims;
    }

    /// 0 stands for the plane that a pixel began with.
    [[nodiscard]] static std::uint8_t stamp_of(int iteration) {
        return static_cast<std::uint8_t>(std::min(iteration + 1, 255));
    }

    /// Mean over the two best views of how badly they fit and disagree.
    [[nodiscard]] float cost(const ReferenceWindow& window, int x, int y,
                             const PixelPlane& plane) const {
        if (!(plane.inverse_depth >= 0)) return kMaxCost;
        std::array<float, kMaxViews> costs;
        window_costs(window, views_, x, y, plane, costs.data());
        float best = kWindowUnseen;
        float second = kWindowUnseen;
        for (std::size_t k = 0; k < views_.size(); ++k) {
            if (costs[k] >= second) continue;
            const float total =
                costs[k] + options_.disagreement_per_px * disagreement_px(k, x, y, plane);
            second = std::min(second, std::max(best, total));
            best = std::min(best, total);
        }
        if (best >= kWindowUnseen) return kMaxCost;
        // One view alone is less to go by.
        constexpr float kLonely = 0.2F;
        return second >= kWindowUnseen ? best + kLonely : 0.5F * (best + second);
    }

    [[nodiscard]] float disagreement_px(std::size_t k, int x, int y,
                                        const PixelPlane& plane) const {
        constexpr float kMaxPx = 3.0F;
        constexpr float kExpectedPx = 0.5F;  // Of an estimate that is to be refined.
        const OtherEstimate& other = estimates_[k];
        const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
        const auto there = other.trip.there.at(pixel, static_cast<double>(plane.inverse_depth));
        const GrayImage& confidence = other.map->confidence;
        const auto found = pixel_in_picture(there, confidence.width(), confidence.height());
        if (!found || confidence(found->x(), found->y()) == 0) return kMaxPx;
        const auto returned = other.trip.returned(
            pixel, there->pixel,
            static_cast<double>(other.map->inverse_depth(found->x(), found->y())));
        if (!returned) return kMaxPx;
        const auto apart = static_cast<float>(returned->error_px);
        return std::clamp(apart - kExpectedPx, 0.0F, kMaxPx);
    }

    void offer(const ReferenceWindow& window, int x, int y, const PixelPlane& plane) {
        const float offered = cost(window, x, y, plane);
        if (offered >= costs_(x, y)) return;
        costs_(x, y) = offered;
        planes_(x, y) = plane;
    }

    /// The planes of pixels that the sweep has passed: next to this one and a window away. What
    /// they offered two sweeps ago, going the same way, was refused or taken then.
    void propagate(const ReferenceWindow& window, int x, int y, int iteration) {
        constexpr int kFar = 5;
        const int step = iteration % 2 == 0 ? 1 : -1;
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {kFar, 0}, {0, kFar}}) {
            const int from_x = x - step * dx;
            const int from_y = y - step * dy;
            if (!planes_.contains(from_x, from_y)) continue;
            if (iteration >= 2 && last_change_(from_x, from_y) < iteration) continue;
            offer(window, x, y, planes_(from_x, from_y).at(step * dx, step * dy));
        }
    }

    /// Small changes of depth and slant, smaller from sweep to sweep.
    void vary(const ReferenceWindow& window, int x, int y, int iteration) {
        constexpr float kFirstPx = 1.0F;
        constexpr float kSlopeShare = 0.15F;
        const auto pixel = static_cast<std::uint32_t>(y * width_ + x);
        const auto round = static_cast<std::uint32_t>(iteration);
        float amount = kFirstPx * one_pixel_ / static_cast<float>(1 << iteration);
        for (std::uint32_t change = 0; change < 2; ++change, amount *= 0.4F) {
            PixelPlane plane = planes_(x, y);
            plane.inverse_depth += amount * hashed(pixel, round, 3 * change);
            offer(window, x, y, plane);
            plane = planes_(x, y);
            plane.right += kSlopeShare * amount * hashed(pixel, round, 3 * change + 1);
            plane.down += kSlopeShare * amount * hashed(pixel, round, 3 * change + 2);
            offer(window, x, y, plane);
        }
    }

    const DepthView& view_;
    const DepthMap& own_;  ///< The estimate that is refined.
    PatchMatchOptions options_;
    GrayImage gray_;
    int width_;
    int height_;
    float one_pixel_;
    std::vector<ComparedView> views_;
    std::vector<OtherEstimate> estimates_;
    Image<PixelPlane> planes_;
    FloatImage costs_;
    GrayImage is_settled_;
    GrayImage last_change_;  ///< stamp_of the iteration that last changed the plane.
};

}  // namespace

DepthMap patch_match(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
                     int view_index, const PatchMatchOptions& options) {
    Refinement refinement(scene, estimates, view_index, options);
    for (int iteration = 0; iteration < options.iterations; ++iteration) {
        refinement.sweep(iteration);
    }
    return refinement.result();
}

}  // namespace lumi
