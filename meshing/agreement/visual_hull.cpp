#include "meshing/agreement/visual_hull.h"

#include <algorithm>
#include <cstddef>

#include "calib/capture/inverse_depth_warp.h"
#include "meshing/depth_scene/views_around.h"
#include "meshing/warp/pixel_in_picture.h"

namespace lumi {
namespace {

constexpr std::size_t kMostAsked = 32;
constexpr int kLeastAgainst = 2;
constexpr int kMostSteps = 4096;  // Along a ray, each way.

/// Whether nothing of the scene is within a pixel.
bool is_surely_background(const GrayImage& mask, int x, int y) {
    if (mask(x, y) != 0) return false;
    for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column) {
            if (mask.contains(column, row) && mask(column, row) != 0) return false;
        }
    }
    return true;
}

std::vector<int> views_to_ask(const DepthScene& scene, int view_index) {
    std::vector<int> asked = views_around(scene, view_index);
    asked.resize(std::min(asked.size(), kMostAsked));
    const std::size_t count = scene.views.size();
    const std::size_t places = std::min(kMostAsked - asked.size(), count);
    for (std::size_t i = 0; i < places; ++i) {
        const auto view = static_cast<int>(i * count / places);
        const bool is_asked = std::find(asked.begin(), asked.end(), view) != asked.end();
        if (view != view_index && !is_asked) asked.push_back(view);
    }
    return asked;
}

}  // namespace

class VisualHull::Rays {
 public:
    Rays(const VisualHull& hull, int view_index) {
        const DepthView& view = hull.scene_.views[static_cast<std::size_t>(view_index)];
        for (const int i : views_to_ask(hull.scene_, view_index)) {
            const GrayImage& mask = hull.masks_[static_cast<std::size_t>(i)];
            if (mask.empty()) continue;
            const DepthView& other = hull.scene_.views[static_cast<std::size_t>(i)];
            asked_.push_back({warp_from(view).to(other), &mask});
        }
    }

    /// Of the point at an inverse depth along the ray of pixel (x, y).
    [[nodiscard]] bool is_outside(int x, int y, float inverse_depth) const {
        int against = 0;
        for (const Asked& other : asked_) {
            const auto pixel = pixel_in_picture(
                other.from_own.at({x + 0.5, y + 0.5}, static_cast<double>(inverse_depth)),
                other.mask->width(), other.mask->height());
            if (!pixel || !is_surely_background(*other.mask, pixel->x(), pixel->y())) continue;
            if (++against == kLeastAgainst) return true;
        }
        return false;
    }

 private:
    struct Asked {
        InverseDepthWarp from_own;
        const GrayImage* mask;
    };
    std::vector<Asked> asked_;
};

VisualHull::VisualHull(const DepthScene& scene, const std::vector<GrayImage>& masks)
    : scene_(scene), masks_(masks) {}

void VisualHull::take_claims_outside(int view_index, DepthMap& map) const {
    if (masks_[static_cast<std::size_t>(view_index)].empty()) return;
    const Rays rays(*this, view_index);
    for (int y = 0; y < map.confidence.height(); ++y) {
        for (int x = 0; x < map.confidence.width(); ++x) {
            std::uint8_t& confidence = map.confidence(x, y);
            if (confidence != 0 && rays.is_outside(x, y, map.inverse_depth(x, y))) confidence = 0;
        }
    }
}

void VisualHull::move_fills_inside(int view_index, DepthMap& map) const {
    const auto index = static_cast<std::size_t>(view_index);
    const DepthView& view = scene_.views[index];
    const GrayImage& mask = masks_[index];
    if (mask.empty() || view.disparity_px_per_inverse_depth <= 0) return;
    const auto far = static_cast<float>(view.range.far);
    const auto near = static_cast<float>(view.range.near);
    const float step = std::max(static_cast<float>(1 / view.disparity_px_per_inverse_depth),
                                (near - far) / kMostSteps);
    const auto steps = static_cast<int>((near - far) / step);
    const Rays rays(*this, view_index);
    const auto moved = [&](int x, int y, float filled) {
        const auto is_inside = [&](float q) {
            return q >= far && q <= near && !rays.is_outside(x, y, q);
        };
        for (int k = 1; k <= steps; ++k) {
            const float way = static_cast<float>(k) * step;
            if (is_inside(filled - way)) return filled - way;
            if (is_inside(filled + way)) return filled + way;
        }
        return filled;
    };
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            float& filled = map.inverse_depth(x, y);
            if (mask(x, y) != 0 && map.confidence(x, y) == 0 && rays.is_outside(x, y, filled))
                filled = moved(x, y, filled);
        }
    }
}

}  // namespace lumi
