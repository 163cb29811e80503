#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "render/depth_search/epipolar_walk.h"
#include "render/depth_search/footprint.h"
#include "render/depth_search/searched_views.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/lumigraph/lumigraph.h"
#include "render/transfer/pixel_transfer.h"

namespace lumi {

/// Where a ray of the eye meets the scene.
struct RayHit {
    static constexpr int kNoView = -1;

    double inverse_depth = 0.0;  ///< Along the eye's optical axis.
    DepthKind kind = DepthKind::kSeen;
    int support = 0;  ///< How many of the views asked meet it there: the first of `views`.
    std::array<int, 3> views{kNoView, kNoView, kNoView};

    /// Nothing else stands before it for this view; of views that were not asked, or that meet
    /// something else, this does not tell.
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
    /// Where none has seen anything it is the guess of the first view that has one: guesses of
    /// several views are as many surfaces, and the nearest of them is part of one and of another.
    /// The third is not asked when the first two have both seen it; the second always is: that it
    /// sees what the first one meets does not tell what it meets before. Empty when the ray meets
    /// nothing in any of them.
    [[nodiscard]] std::optional<RayHit> first_hit(const Eigen::Vector2d& pixel,
                                                  const std::array<int, 3>& view_indices) const;

    /// 1 when the view sees the point at `inverse_depth` on the eye's ray through `pixel`, 0 when
    /// it sees something else or the point lies outside of its photograph; between, a ramp.
    [[nodiscard]] double visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                                    int view_index) const;

    /// By how many pixels of disparity something that the view has seen stands before the point at
    /// `inverse_depth` on the eye's ray through `pixel`; 0 where nothing does, or where the point
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

    [[nodiscard]] EpipolarLine line_in(int view_index, const Eigen::Vector2d& pixel) const;

 private:
    /// A view as the eye needs it.
    struct Target {
        PixelTransfer view_from_eye;
        Eigen::Vector2d samples_per_pixel = Eigen::Vector2d::Zero();
        double disparity_px = 0.0;  ///< Pixels per unit of inverse depth (view_geometry.h).
        double max_disparity_px = 0.0;
        int width_px = 0;
        int height_px = 0;
        const TiledDepth* depth = nullptr;
        bool sees_thin = false;
    };
    /// What a view sees at a place in its depth map.
    struct Surface {
        double inverse_depth;  ///< Interpolated; where it tears the nearest sample's.
        DepthKind kind;        ///< Of the nearest sample.
    };
    /// The view's ray at a point of the eye's ray.
    struct Meeting {
        double share;  ///< Of its way.
        Surface surface;
        double ahead;  ///< Inverse depth of the point in the view, less the surface's.
    };
    [[nodiscard]] static Surface surface_at(const Target& target, double x, double y);
    [[nodiscard]] static Meeting meeting_at(const Target& target, const EpipolarWalk& walk,
                                            double share);
    [[nodiscard]] static RayHit hit_at(const EpipolarWalk& walk, const Meeting& meeting,
                                       int view_index) {
        return {walk.inverse_depth_in_eye(meeting.share),
                meeting.surface.kind,
                1,
                {view_index, RayHit::kNoView, RayHit::kNoView}};
    }
    /// The nearest that two have seen, or else the nearest that one has.
    [[nodiscard]] std::optional<RayHit> nearest_seen(
        const std::array<std::optional<RayHit>, 3>& hits) const;
    /// What the view sees at a point of the eye's line into it.
    [[nodiscard]] static Surface surface_at(const Target& target, const Eigen::Vector3d& in_view) {
        const Eigen::Vector2d in_depth =
            in_view.hnormalized().cwiseProduct(target.samples_per_pixel);
        return surface_at(target, in_depth.x(), in_depth.y());
    }
    /// Over which a point lies in a photograph, and not before or behind all that it shows.
    [[nodiscard]] RayStretch visible_stretch(const Target& target, const EpipolarLine& line) const;
    [[nodiscard]] std::optional<RayHit> first_hit_in(int view_index,
                                                     const Eigen::Vector2d& pixel) const;
    /// Whether a point is on the surface, by this share of what depths of one may differ by.
    [[nodiscard]] bool is_at_surface(const Target& target, const Meeting& meeting,
                                     double share) const {
        return std::abs(meeting.ahead) * target.max_disparity_px <= share * kAgreeingDisparity_px;
    }
    /// The hit between a share of the way before the surface and one behind it; empty at a tear.
    [[nodiscard]] std::optional<RayHit> refined(int view_index, const EpipolarWalk& walk,
                                                double before, double behind) const;

    double occlusion_tolerance_px_;
    double agreeing_inverse_depth_;
    double max_inverse_depth_;  ///< Of the eye: nothing nearer is looked for.
    double least_inverse_depth_;
    bool has_depth_ = false;
    bool has_thin_ = false;
    std::vector<Target> targets_;
};

}  // namespace lumi
