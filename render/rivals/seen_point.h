#pragma once

#include <optional>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What the eye sees at a pixel's centre, homogeneous in the world: with an inverse depth of 0 it
/// is infinitely far.
[[nodiscard]] Eigen::Vector4d scene_point(const Eye& eye, int x, int y, double inverse_depth);

/// Whether inverse depths are of one surface: they differ by no more than this share of the greater
/// one. What is farther than ten times the scene's near end is compared as if it were there, so
/// that what is infinitely far is of one surface, too.
class SameSurface {
 public:
    SameSurface(const Lumigraph& lumigraph, double share);
    [[nodiscard]] bool operator()(double inverse_depth, double other) const;

 private:
    double share_;
    double least_compared_;
};

/// Where a point of the scene lies in one view's photograph, whatever that shows there.
struct PhotographedPoint {
    const LumigraphView* view = nullptr;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    double inverse_depth = 0.0;  ///< Of the point, in the view.

    [[nodiscard]] Eigen::Vector3d color() const;  ///< 0 to 255.
    /// 1 well inside of the photograph; it fades to 0 at its border as in lumi's own modes.
    [[nodiscard]] double share_in_view() const;
};

/// Empty when the point lies behind the view or outside of its photograph.
[[nodiscard]] std::optional<PhotographedPoint> photographed_point(
    const LumigraphView& view, const Eigen::Vector4d& point_in_world);

/// The same, and what the view sees there.
struct SeenPoint : PhotographedPoint {
    double map_inverse_depth = 0.0;  ///< Of what the view sees.

    /// Whether the point is what the view sees.
    [[nodiscard]] bool is_of(const SameSurface& same_surface) const;
};

/// As photographed_point. The view has depth.
[[nodiscard]] std::optional<SeenPoint> seen_point(const LumigraphView& view,
                                                  const Eigen::Vector4d& point_in_world);

/// Of a hundred times the distance of the farthest view: what is farther is weighed as if it were
/// there, as angles between views are too small beyond to tell them apart.
[[nodiscard]] double least_weighed_inverse_depth(const Lumigraph& lumigraph, const Eye& eye);

/// Covered, with a colour from 0 to 255.
void set_pixel(Frame& frame, int x, int y, const Eigen::Vector3d& color);

}  // namespace lumi
