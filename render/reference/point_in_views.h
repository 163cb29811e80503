#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "render/depth_layers/depth_layer_views.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/depth_raster.h"
#include "render/reference/photograph_samples.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// A scene point on the eye's ray: eye + direction / inverse_depth, perhaps infinitely far.
struct RayPoint {
    Eigen::Vector3d direction_in_world;  ///< Of unit depth along the eye's optical axis.
    double inverse_depth = 0.0;
    int known_by = kNoView;  ///< The first of the views whose depth says so.
};

/// A point as one view sees it.
struct Sight {
    Eigen::Vector2d pixel;
    double inverse_depth = 0.0;
    double depth_ratio = 1.0;  ///< Of its depth in the view over that in the eye.
};

/// What the views of a Lumigraph show of points on an eye's rays.
class PointInViews {
 public:
    /// Lumigraph and options must outlive it.
    PointInViews(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options);

    /// None where the point is behind the view.
    [[nodiscard]] std::optional<Sight> sight(int view_index, const RayPoint& point) const;
    /// Whether the point is in the view's photograph.
    [[nodiscard]] bool is_inside(int view_index, const RayPoint& point) const;
    /// 1 when the view sees the point, 0 when it sees something else or the point is not in its
    /// photograph; in between a ramp (occlusion.h). A view that was asked for depth has said what
    /// it sees on the eye's ray, of others the depth map tells. In its place nothing moves: there a
    /// view sees all that it shows, whatever it knows.
    [[nodiscard]] double visibility(int view_index, const RayPoint& point,
                                    const std::map<int, EyeDepth>& asked) const;
    /// Whether the view's depth map has something surely before a point that is a guess
    /// (occlusion.h), if guesses are checked.
    [[nodiscard]] bool is_guess_hidden(int view_index, const RayPoint& point) const;
    /// Whether it has nothing there at all, infinitely far, if guesses are checked.
    [[nodiscard]] bool sees_past_guess(int view_index, const RayPoint& point) const;
    /// How much the photograph counts there, 0 to 255.
    [[nodiscard]] double opacity(int view_index, const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d color(int view_index, const RayPoint& point) const;
    /// Whether it sees all of the scene as the eye does, to a pixel (photograph_opacity.h).
    [[nodiscard]] bool is_where_the_eye_is(int view_index) const;
    [[nodiscard]] const std::vector<ViewGeometry>& geometries() const { return geometries_; }

 private:
    /// The inverse depth in the view of what it sees there; as far as can be from any where it
    /// knows nothing. The view has depth.
    [[nodiscard]] double seen_by(int view_index, const Sight& sight,
                                 const std::map<int, EyeDepth>& asked) const;
    [[nodiscard]] bool checks_guess_in(int view_index, const RayPoint& point) const;
    [[nodiscard]] const LumigraphView& view(int index) const {
        return lumigraph_.views[static_cast<std::size_t>(index)];
    }

    const Lumigraph& lumigraph_;
    const RenderOptions& options_;
    Eigen::Vector3d eye_in_world_;
    std::vector<ViewGeometry> geometries_;
    PhotographSamples photographs_;
};

}  // namespace lumi
