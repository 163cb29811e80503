#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lumi {

/// Lens models with COLMAP's names, ids and parameter order (COLMAP 3.8, base/camera_models.h).
enum class LensModel : int {
    kSimplePinhole = 0,  ///< f, cx, cy
    kPinhole = 1,        ///< fx, fy, cx, cy
    kSimpleRadial = 2,   ///< f, cx, cy, k1
    kRadial = 3,         ///< f, cx, cy, k1, k2
    kOpenCv = 4,         ///< fx, fy, cx, cy, k1, k2, p1, p2
    kOpenCvFisheye = 5,  ///< fx, fy, cx, cy, k1, k2, k3, k4
    kFullOpenCv = 6,     ///< fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6
};

[[nodiscard]] std::string_view name_of(LensModel model);
[[nodiscard]] std::optional<LensModel> lens_model_named(std::string_view name);
[[nodiscard]] bool is_lens_model(int id);
[[nodiscard]] std::size_t parameter_count(LensModel model);
/// True for the models that begin f, cx, cy; the others begin fx, fy, cx, cy.
[[nodiscard]] bool has_one_focal_length(LensModel model);
/// Index of the first parameter behind the principal point.
[[nodiscard]] std::size_t first_distortion_parameter(LensModel model);

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
