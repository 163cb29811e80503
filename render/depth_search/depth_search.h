#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "render/depth_search/epipolar_walk.h"
#include "render/depth_search/footprint.h"
#include "render/depth_search/searched_views.h"
#include "render/depth_search/view_search.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Where a ray of the eye meets the scene.
struct RayHit {
    double inverse_depth = 0.0;  ///< Along the eye's optical axis.
    DepthKind kind = DepthKind::kSeen;
    int support = 0;  ///< How many of the views asked meet it there: the first of `views`.
    std::array<int, 3> views{kNoView, kNoView, kNoView};

    /// Whether this view is one of those that meet it, so that nothing hides it from the view.
    /// False tells nothing: the view may not have been asked.
    [[nodiscard]] bool is_met_by(int view_index) const {
        return view_index == views[0] || view_index == views[1] || view_index == views[2];
    }
};

/// Finds where rays of one eye first meet the scene in the depth maps of views that stand
/// elsewhere: the inverse search of Vogelgsang and Greiner (2000), which the paper uses for depth
/// (section 4), here along the epipolar line from near to far.
class DepthSearch {
 public:
    /// Keeps references to the depth maps of `views`, which are the lumigraph's.
    DepthSearch(const Lumigraph& lumigraph, const SearchedViews& views, const Eye& eye);

    /// What the ray through `pixel` meets first in the depth maps of three views (a view may be
    /// named twice): of what they have seen the nearest that two agree on, or else the nearest.
    /// What one has seen alone before that counts where neither of the two looks past it, as
    /// something nearer hides it from both (depth_layers/lone_surfaces.h). Where none has seen
    /// anything it is the guess of the first view that has one: guesses of several views are as
    /// many surfaces, and the nearest of them is part of one and of another. The third is not asked
    /// when the first two have both seen it; the second always is: that it sees what the first one
    /// meets does not tell what it meets before. Empty when the ray meets nothing in any of them.
    [[nodiscard]] std::optional<RayHit> first_hit(const Eigen::Vector2d& pixel,
                                                  const std::array<int, 3>& view_indices) const;

    /// 1 when the view sees the point at `inverse_depth` on the eye's ray through `pixel`, 0 when
    /// it sees something else or the point lies outside of its photograph; between, a ramp. A view
    /// without depth, of which nothing tells, is taken to see what is in its photograph.
    [[nodiscard]] double visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                                    int view_index) const;

    /// Disparity, in pixels, between the point at `inverse_depth` on the eye's ray through `pixel`
    /// and something that the view has seen before it; 0 where there is nothing, or where the point
    /// lies outside of its photograph.
    [[nodiscard]] double hidden_by_px(const Eigen::Vector2d& pixel, double inverse_depth,
                                      int view_index) const;

    /// Whether a view that sees thin things (SearchedViews::thin) has seen something within a flat
    /// triangle of the scene and before it, by more than so many pixels of disparity. Wider things
    /// are found by the triangle's corners. `corners` as the view sees them: in its pixels, with
    /// their inverse depths in the view.
    [[nodiscard]] bool is_part_hidden(const Footprint& corners, double least_px,
                                      int view_index) const;

    /// How much a view counts at a pixel near the border of its photograph; 0 outside.
    [[nodiscard]] double inside(int view_index, const Eigen::Vector2d& view_pixel) const;

    /// How far inside of its photograph a view sees it (shell_opacity.h).
    [[nodiscard]] double inner_share_of(int view_index, const Eigen::Vector2d& view_pixel) const;

    /// Whether one hit lies before another by more than two views of one surface may differ.
    [[nodiscard]] bool is_before(const RayHit& hit, const RayHit& other) const {
        return hit.inverse_depth > other.inverse_depth + agreeing_inverse_depth_;
    }

    /// Whether any view has a depth map.
    [[nodiscard]] bool has_depth() const { return has_depth_; }
    /// Whether any view sees thin things (SearchedViews::thin).
    [[nodiscard]] bool has_thin() const { return has_thin_; }

    /// What is farther is as good as infinitely far.
    [[nodiscard]] double least_inverse_depth() const { return least_inverse_depth_; }

    /// The places in the view's photograph at which it sees the eye's ray.
    [[nodiscard]] EpipolarLine line_in(int view_index, const Eigen::Vector2d& pixel) const {
        return view(view_index).line_of(pixel);
    }

 private:
    [[nodiscard]] const ViewSearch& view(int index) const {
        return views_[static_cast<std::size_t>(index)];
    }
    [[nodiscard]] std::optional<RayHit> first_hit_in(int view_index,
                                                     const Eigen::Vector2d& pixel) const;
    /// The nearest that two have seen, or else the nearest that one has.
    [[nodiscard]] std::optional<RayHit> nearest_seen(
        const std::array<std::optional<RayHit>, 3>& hits) const;
    /// The nearest hit, if it lies before what others agree on and none of these looks past it.
    [[nodiscard]] std::optional<RayHit> lone_hit_before(
        const RayHit& agreed, const Eigen::Vector2d& pixel,
        const std::array<std::optional<RayHit>, 3>& hits) const;
    /// Whether the view sees something behind the point on the eye's ray, at no more than
    /// `nearest_seen` of the eye's inverse depth, where that lies in its photograph.
    [[nodiscard]] bool looks_past(const Eigen::Vector2d& pixel, double inverse_depth,
                                  double nearest_seen, int view_index) const;

    double occlusion_tolerance_px_;
    double agreeing_inverse_depth_ = 0.0;
    double least_inverse_depth_;
    bool has_depth_;
    bool has_thin_ = false;
    std::vector<ViewSearch> views_;
    std::vector<bool> sees_thin_;  ///< The same views.
};

}  // namespace lumi
