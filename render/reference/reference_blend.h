#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "meshing/surface/camera_mesh.h"
#include "render/faces/face_polygons.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/known_points.h"
#include "render/reference/pixel_weights.h"
#include "render/reference/point_in_views.h"

namespace lumi {

struct DrawnPixel {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double coverage = 0.0;  ///< 0 for a guess.
};

/// How photographs are blended at a point on an eye's ray: on a plane as the light field, or where
/// depth says with the paper's occlusion correction (section 4).
class ReferenceBlend {
 public:
    /// What is passed must outlive it. `polygons`: of draw_reference.
    ReferenceBlend(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options,
                   const std::optional<std::vector<FacePolygon>>& polygons);

    [[nodiscard]] const KnownPoints& points() const { return points_; }
    [[nodiscard]] bool is_in_blocks() const { return is_in_blocks_; }
    /// `shared` is what the fragment of a pixel is drawn for, its centre or that of its block.
    /// Nothing where there is nothing to show.
    [[nodiscard]] std::optional<DrawnPixel> at(const KnownPoint& shared,
                                               const Eigen::Vector2d& pixel) const;
    /// Lays what the shell's views show over what is drawn.
    void lay_over(DrawnPixel& drawn, const CameraMesh& shell, const KnownPoint& known) const;

 private:
    /// The light field: those of the ray's views are blended whose photographs hold the point.
    [[nodiscard]] std::optional<DrawnPixel> on_plane(const RayWeights& ray,
                                                     const KnownPoint& shared,
                                                     const Eigen::Vector2d& pixel) const;
    /// Those are blended that see the point, by how much their photographs count there. Where none
    /// does the view tells that the depth is from.
    [[nodiscard]] std::optional<DrawnPixel> at_depth(const RayWeights& ray,
                                                     const KnownPoint& shared,
                                                     const Eigen::Vector2d& pixel) const;
    /// Where the pixel itself is looked up.
    [[nodiscard]] RayPoint point_of(const Eigen::Vector2d& pixel, const KnownPoint& shared) const;
    /// 1 for views whose photographs hold the point, 0 for others.
    [[nodiscard]] std::array<double, 3> holding(const RayWeights& ray, const RayPoint& point) const;
    /// How far the views see the point, where depth is known or a guess stands for it.
    [[nodiscard]] std::array<double, 3> visibilities(const RayWeights& ray,
                                                     const KnownPoint& known) const;
    /// Of a guess, where any views see past it.
    void leave_to_those_that_see_past(const RayWeights& ray, const RayPoint& guess,
                                      std::array<double, 3>& seen) const;
    [[nodiscard]] std::array<double, 3> opacities(const std::array<double, 3>& weights,
                                                  const RayWeights& ray,
                                                  const RayPoint& point) const;
    /// How much the photographs count for the pixel, by their weights; one in the eye's place in
    /// any case.
    [[nodiscard]] double counting_share(const std::array<double, 3>& weights,
                                        const std::array<double, 3>& opaque,
                                        const RayWeights& ray) const;
    /// Without weights as the view shows it that knows the point.
    [[nodiscard]] Eigen::Vector3d color_of(RayWeights ray,
                                           const std::optional<std::array<double, 3>>& weights,
                                           const KnownPoint& shared, const RayPoint& point,
                                           double occluded) const;
    [[nodiscard]] Eigen::Vector3d blended(const RayWeights& ray, const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d debug_color_of(const RayWeights& ray, bool unseen,
                                                 const KnownPoint& known, double occluded) const;
    [[nodiscard]] const Camera& camera_of(int view) const {
        return lumigraph_.views[static_cast<std::size_t>(view)].camera;
    }

    const Lumigraph& lumigraph_;
    const RenderOptions& options_;
    Eigen::Vector3d eye_in_world_;
    PointInViews views_;
    KnownPoints points_;
    PixelWeights weights_;
    bool is_in_blocks_;
};

}  // namespace lumi
