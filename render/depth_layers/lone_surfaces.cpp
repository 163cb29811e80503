#include "render/depth_layers/lone_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>

#include "calib/work/parallel_for.h"
#include "render/depth_layers/depth_kind_ranges.h"
#include "render/depth_layers/depth_layer_rasters.h"
#include "render/depth_layers/depth_layer_views.h"
#include "render/transfer/past_sight.h"

namespace lumi {
namespace {

constexpr std::size_t kComponents = DepthLayerRasters::kPacked;
constexpr auto kSeenEnds = static_cast<float>(kDepthKindStep);
constexpr float kNothing = 1.0F;

/// What the layers hold at one texel.
class LayerTexel {
 public:
    LayerTexel(float* depths, float agreeing) : depths_(depths), agreeing_(agreeing) {}

    [[nodiscard]] float nearest() const {
        return *std::min_element(depths_, depths_ + kComponents);
    }

    /// Whether the nearest is seen, and no other agrees with it: at few texels. Without a branch.
    [[nodiscard]] bool is_nearest_alone() const {
        static_assert(kComponents == 4);
        const auto [near_a, far_a] = std::minmax(depths_[0], depths_[1]);
        const auto [near_b, far_b] = std::minmax(depths_[2], depths_[3]);
        const float nearest = std::min(near_a, near_b);
        const float next = std::min({std::max(near_a, near_b), far_a, far_b});
        return nearest < kSeenEnds && next - nearest > agreeing_;
    }

    [[nodiscard]] bool is_seen(std::size_t layer) const { return depths_[layer] < kSeenEnds; }

    [[nodiscard]] bool agrees(std::size_t layer, float depth) const {
        return std::abs(depths_[layer] - depth) <= agreeing_;
    }

    [[nodiscard]] int support_of(float depth) const {
        int support = 0;
        for (std::size_t layer = 0; layer < kComponents; ++layer)
            support += agrees(layer, depth) ? 1 : 0;
        return support;
    }

    /// The nearest that is seen and that two agree on; nothing where there is none.
    [[nodiscard]] float first_agreed() const {
        float first = kNothing;
        for (std::size_t layer = 0; layer < kComponents; ++layer)
            if (is_seen(layer) && support_of(depths_[layer]) > 1)
                first = std::min(first, depths_[layer]);
        return first;
    }

    /// Of the layers that agree on a depth.
    template <class Condition>
    [[nodiscard]] bool any_of_those_at(float depth, const Condition& condition) const {
        for (std::size_t layer = 0; layer < kComponents; ++layer)
            if (agrees(layer, depth) && condition(layer)) return true;
        return false;
    }

    /// Of the layers that have seen something else.
    template <class Condition>
    [[nodiscard]] bool any_seen_beside(float depth, const Condition& condition) const {
        for (std::size_t layer = 0; layer < kComponents; ++layer)
            if (is_seen(layer) && !agrees(layer, depth) && condition(layer)) return true;
        return false;
    }

    void take_away_those_at(float depth) {
        for (std::size_t layer = 0; layer < kComponents; ++layer)
            if (agrees(layer, depth)) depths_[layer] = kNothing;
    }

 private:
    float* depths_;
    float agreeing_;
};

/// Of the layers in a strip; null where a layer shows no view.
using LayerSights = std::array<const PastSight*, kComponents>;

class LoneSurfaces {
 public:
    LoneSurfaces(const std::vector<LumigraphView>& views, const Eye& eye,
                 const std::vector<DepthViewSet>& sets, int layers, double max_inverse_depth,
                 float agreeing_depth)
        : strip_ends_(strip_ends(sets, eye.camera.width_px)),
          height_(eye.camera.height_px),
          max_inverse_depth_(max_inverse_depth),
          agreeing_depth_(agreeing_depth),
          agreeing_(inverse_depth_of(0) - inverse_depth_of(agreeing_depth)) {
        for (const std::vector<int>& of_set : depth_layer_views(sets, layers)) {
            LayerSights& sights = sights_of_strips_.emplace_back();
            for (std::size_t layer = 0; layer < of_set.size(); ++layer) {
                if (of_set[layer] == kNoView) continue;
                const LumigraphView& view = views[static_cast<std::size_t>(of_set[layer])];
                if (view.has_depth())
                    sights[layer] = &sights_.try_emplace(of_set[layer], view, eye).first->second;
            }
        }
    }

    void settle_row(int row, float* texels) const {
        int column = 0;
        for (std::size_t strip = 0; strip < strip_ends_.size(); ++strip) {
            for (; column < strip_ends_[strip]; ++column) {
                const LayerTexel texel(texels + kComponents * static_cast<std::size_t>(column),
                                       agreeing_depth_);
                if (texel.is_nearest_alone())
                    settle(texel, {column + 0.5, height_ - row - 0.5}, sights_of_strips_[strip]);
            }
        }
    }

 private:
    /// Of a texel whose nearest is alone.
    void settle(LayerTexel texel, const Eigen::Vector2d& pixel, const LayerSights& sights) const {
        while (texel.is_nearest_alone()) {
            const float nearest = texel.nearest();
            const auto past = [&](std::size_t layer, double nearest_seen) {
                return sights[layer] == nullptr
                           ? Past::kNot
                           : sights[layer]->past(pixel, inverse_depth_of(nearest), agreeing_,
                                                 nearest_seen);
            };
            const float agreed = texel.first_agreed();
            if (agreed != kNothing) {
                const double nearest_seen =
                    nearest_seen_past_for(inverse_depth_of(agreed), agreeing_);
                const bool is_imagined = texel.any_of_those_at(agreed, [&](std::size_t layer) {
                    return past(layer, nearest_seen) != Past::kNot;
                });
                if (!is_imagined) texel.take_away_those_at(agreed);
                return;
            }
            const bool is_imagined = texel.any_seen_beside(nearest, [&](std::size_t layer) {
                return past(layer, kAnywhere) == Past::kSurely;
            });
            if (!is_imagined) return;
            texel.take_away_those_at(nearest);
        }
    }

    /// Of what is seen.
    [[nodiscard]] double inverse_depth_of(float depth) const {
        return max_inverse_depth_ * (1 - static_cast<double>(depth) / kDepthKindWidth);
    }

    std::vector<int> strip_ends_;
    std::vector<LayerSights> sights_of_strips_;
    std::map<int, PastSight> sights_;  ///< By the view's index.
    int height_;
    double max_inverse_depth_;
    float agreeing_depth_;
    double agreeing_;  ///< The same as inverse depth.
};

}  // namespace

void settle_lone_surfaces(const std::vector<LumigraphView>& views, const Eye& eye,
                          const std::vector<DepthViewSet>& sets, int layers,
                          double max_inverse_depth, float agreeing_depth,
                          std::vector<float>& packed) {
    const LoneSurfaces surfaces(views, eye, sets, layers, max_inverse_depth, agreeing_depth);
    const auto row_size = kComponents * static_cast<std::size_t>(eye.camera.width_px);
    constexpr std::size_t kRowsAtATime = 8;
    parallel_for_runs(static_cast<std::size_t>(eye.camera.height_px), kRowsAtATime, 0,
                      [&](std::size_t first, std::size_t end) {
                          for (std::size_t row = first; row < end; ++row)
                              surfaces.settle_row(static_cast<int>(row),
                                                  packed.data() + row * row_size);
                      });
}

}  // namespace lumi
