#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "calib/capture/inverse_depth_warp.h"
#include "render/depth_search/epipolar_walk.h"
#include "render/depth_search/tiled_depth.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/lumigraph/lumigraph.h"
#include "render/transfer/border_distance.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// What a view sees at a place in its depth map.
struct SeenSurface {
    double inverse_depth;  ///< In the view: interpolated; where it tears the nearest sample's.
    DepthKind kind;        ///< Of the nearest sample.
};

/// Where a ray of the eye meets what one view sees.
struct ViewHit {
    double inverse_depth;  ///< Along the eye's optical axis.
    DepthKind kind;
};

/// One view as rays of one eye are looked for in it (depth_search.h). Without a depth map it sees
/// nothing.
class ViewSearch {
 public:
    /// Keeps a reference to the depth map. Nothing nearer to the eye than `max_inverse_depth` is
    /// looked for.
    ViewSearch(const LumigraphView& view, const TiledDepth& depth, const ViewGeometry& geometry,
               const Eye& eye, double max_inverse_depth);

    [[nodiscard]] const TiledDepth& depth() const { return *depth_; }
    [[nodiscard]] const Eigen::Vector2d& samples_per_pixel() const { return samples_per_pixel_; }
    /// Pixels per unit of inverse depth, as the eye sees them (view_geometry.h).
    [[nodiscard]] double disparity_px() const { return disparity_px_; }
    /// The smaller side of its photograph.
    [[nodiscard]] int smaller_side_px() const { return std::min(width_px_, height_px_); }
    /// From a place in its photograph to the nearest border; negative beyond it.
    [[nodiscard]] double to_border_px(const Eigen::Vector2d& pixel) const {
        return border_distance_px(pixel, width_px_, height_px_);
    }

    /// The places in its photograph at which it sees the eye's ray through `eye_pixel`.
    [[nodiscard]] EpipolarLine line_of(const Eigen::Vector2d& eye_pixel) const {
        return {view_from_eye_.infinite_homography * eye_pixel.homogeneous(),
                view_from_eye_.epipole};
    }

    /// At a pixel of the photograph; needs a depth map.
    [[nodiscard]] SeenSurface surface_at(const Eigen::Vector2d& pixel) const {
        const Eigen::Vector2d in_depth = pixel.cwiseProduct(samples_per_pixel_);
        return surface_at_sample(in_depth.x(), in_depth.y());
    }

    /// Where the eye's ray through the pixel first meets what the view sees or guesses, along the
    /// epipolar line from near to far; empty when it meets nothing.
    [[nodiscard]] std::optional<ViewHit> first_hit(const Eigen::Vector2d& eye_pixel) const;

 private:
    /// A point of the eye's ray, and the surface that the view sees there.
    struct Meeting {
        double share;  ///< Of the ray's way through the depth map (EpipolarWalk).
        SeenSurface surface;
        double ahead;  ///< Inverse depth of the point in the view, less the surface's.
    };
    [[nodiscard]] SeenSurface surface_at_sample(double x, double y) const;
    [[nodiscard]] Meeting meeting_at(const EpipolarWalk& walk, double share) const;
    [[nodiscard]] static ViewHit hit_at(const EpipolarWalk& walk, const Meeting& meeting) {
        return {walk.inverse_depth_in_eye(meeting.share), meeting.surface.kind};
    }
    [[nodiscard]] EpipolarLine line_in_samples(const Eigen::Vector2d& eye_pixel) const;
    /// The stretch of the ray whose points lie in the photograph, and not before or behind all that
    /// it shows.
    [[nodiscard]] RayStretch visible_stretch(const EpipolarLine& line) const;
    /// Whether the point is on the surface: off it by at most `share` of the disparity by which
    /// depths of one surface may differ.
    [[nodiscard]] bool is_at_surface(const Meeting& meeting, double share) const {
        return std::abs(meeting.ahead) * max_disparity_px_ <= share * kAgreeingDisparity_px;
    }
    /// Whether the eye cannot tell a ray that comes in over the photograph's border, already behind
    /// the surface there, from one that meets the surface. What a view knows of depth is worth
    /// little to an eye that is much farther off than other views are.
    [[nodiscard]] bool meets_at_border(const Meeting& meeting) const {
        return -meeting.ahead * focal_times_way_ <= kAgreeingDisparity_px;
    }
    /// Where the ray would meet the surface if that were everywhere as far from the view as it is
    /// at `from`, which lies before it; empty unless that is close ahead.
    [[nodiscard]] std::optional<Meeting> close_ahead(const EpipolarWalk& walk,
                                                     const Meeting& from) const;
    /// The hit on a surface that was crossed from one share of the way to another, which may each
    /// be off by a step; empty at a tear.
    [[nodiscard]] std::optional<ViewHit> crossed(const EpipolarWalk& walk, double before,
                                                 double behind) const;
    /// The hit between a share of the way before the surface and one behind it; empty at a tear.
    [[nodiscard]] std::optional<ViewHit> refined(const EpipolarWalk& walk, double before,
                                                 double behind) const;

    InverseDepthWarp view_from_eye_;
    Eigen::Vector2d samples_per_pixel_;
    double disparity_px_;
    double max_disparity_px_;
    double focal_times_way_;  ///< The view's focal length (px) times its distance from the eye.
    int width_px_;
    int height_px_;
    const TiledDepth* depth_;
    double max_inverse_depth_;  ///< Of the eye.
};

}  // namespace lumi
