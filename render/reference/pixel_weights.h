#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "render/faces/blend_strips.h"
#include "render/faces/face_polygons.h"

namespace lumi {

/// Which views the rays of one eye are blended from, pixel by pixel: by the camera mesh; where it
/// has no faces by the strips of the eye's blends; or by polygons that take their place.
class PixelWeights {
 public:
    /// Keeps references to the mesh and the polygons.
    PixelWeights(const CameraMesh& mesh, const Eye& eye,
                 const std::optional<std::vector<FacePolygon>>& polygons);

    /// Empty where no view is blended. `direction_in_world` is that of the ray, which may be that
    /// of a block's middle.
    [[nodiscard]] std::optional<RayWeights> at(const Eigen::Vector2d& pixel,
                                               const Eigen::Vector3d& direction_in_world) const;

 private:
    const CameraMesh& mesh_;
    const std::optional<std::vector<FacePolygon>>& polygons_;
    Eigen::Vector3d eye_in_world_;
    std::vector<EyeBlend> blends_;  ///< None where the camera mesh has faces.
    std::vector<int> strip_ends_;   ///< Of these.
};

/// Weights times what is shown, scaled to sum 1, on one plane, however little they count: beside a
/// camera the others have weights near 0, but beyond its photograph they are all there is. Empty
/// where nobody shows the point.
[[nodiscard]] std::optional<std::array<double, 3>> of_those_that_show(
    std::array<double, 3> weights, const std::array<double, 3>& shown);

}  // namespace lumi
