#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/lens_model.h"

namespace lumi {

/// A lens and its sensor. Pixels are continuous: (0.5, 0.5) is the centre of the top-left pixel.
struct Camera {
    int width_px = 0;
    int height_px = 0;
    LensModel model = LensModel::kPinhole;
    std::vector<double> parameters;  ///< In the order of its model, lengths in pixels.

    friend bool operator==(const Camera&, const Camera&) = default;
};

[[nodiscard]] Camera pinhole_camera(int width_px, int height_px, double focal_length_px);

[[nodiscard]] Eigen::Vector2d focal_length_px(const Camera& camera);
[[nodiscard]] Eigen::Vector2d principal_point_px(const Camera& camera);
/// True when straight lines stay straight: the model has no distortion, or all of it is zero.
[[nodiscard]] bool is_pinhole(const Camera& camera);

/// The same lens on a sensor of another size, as after resampling the photograph.
[[nodiscard]] Camera resized(const Camera& camera, int width_px, int height_px);

/// Throws Error (E-CAMERA-INVALID) unless sizes are positive, every parameter is finite and the
/// focal length is positive; `where` begins the message.
void validate(const Camera& camera, const std::string& where);

/// Pixel at which `camera` sees a point. Empty when the point is not in front of the camera: an
/// answer, not an error. The pixel may lie outside the sensor.
[[nodiscard]] std::optional<Eigen::Vector2d> project(const Camera& camera,
                                                     const Eigen::Vector3d& point_in_cam);

/// The point at depth z = 1 that is seen at `pixel`; distortion is inverted by Newton's method.
[[nodiscard]] Eigen::Vector3d unproject(const Camera& camera, const Eigen::Vector2d& pixel);

[[nodiscard]] inline bool is_inside(const Camera& camera, const Eigen::Vector2d& pixel) {
    return pixel.x() >= 0 && pixel.y() >= 0 && pixel.x() < camera.width_px &&
           pixel.y() < camera.height_px;
}

}  // namespace lumi
