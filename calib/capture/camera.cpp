#include "calib/capture/camera.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "calib/capture/lens_distortion.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr double kMinDepth = 1e-12;

Eigen::Vector2d distort(const Camera& camera, const Eigen::Vector2d& point) {
    return with_lens_model(camera.model, [&](auto model) {
        const double* k = camera.parameters.data() + first_distortion_parameter(model);
        return distorted<model>(point, k);
    });
}

Eigen::Matrix2d distortion_jacobian(const Camera& camera, const Eigen::Vector2d& point) {
    constexpr double kStep = 1e-6;
    Eigen::Matrix2d jacobian;
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector2d offset = kStep * Eigen::Vector2d::Unit(axis);
        jacobian.col(axis) =
            (distort(camera, point + offset) - distort(camera, point - offset)) / (2 * kStep);
    }
    return jacobian;
}

}  // namespace

Camera pinhole_camera(int width_px, int height_px, double focal_length_px) {
    return {width_px,
            height_px,
            LensModel::kPinhole,
            {focal_length_px, focal_length_px, width_px / 2.0, height_px / 2.0}};
}

Eigen::Vector2d focal_length_px(const Camera& camera) {
    const auto& p = camera.parameters;
    return has_one_focal_length(camera.model) ? Eigen::Vector2d(p[0], p[0])
                                              : Eigen::Vector2d(p[0], p[1]);
}

Eigen::Vector2d principal_point_px(const Camera& camera) {
    const auto& p = camera.parameters;
    const std::size_t cx = principal_point_index(camera.model);
    return {p[cx], p[cx + 1]};
}

bool is_pinhole(const Camera& camera) {
    if (camera.model == LensModel::kOpenCvFisheye) return false;  // Equidistant even with k = 0.
    const auto first = camera.parameters.begin() +
                       static_cast<std::ptrdiff_t>(first_distortion_parameter(camera.model));
    return std::all_of(first, camera.parameters.end(), [](double k) { return k == 0.0; });
}

Camera resized(const Camera& camera, int width_px, int height_px) {
    const double scale_x = static_cast<double>(width_px) / camera.width_px;
    const double scale_y = static_cast<double>(height_px) / camera.height_px;
    Camera result = camera;
    result.width_px = width_px;
    result.height_px = height_px;
    if (has_one_focal_length(camera.model)) {
        // One focal length cannot follow two scales; they differ by the rounding of the size only.
        result.parameters[0] *= 0.5 * (scale_x + scale_y);
        result.parameters[1] *= scale_x;
        result.parameters[2] *= scale_y;
    } else {
        result.parameters[0] *= scale_x;
        result.parameters[1] *= scale_y;
        result.parameters[2] *= scale_x;
        result.parameters[3] *= scale_y;
    }
    return result;
}

void validate(const Camera& camera, const std::string& where) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kBadInput, "E-CAMERA-INVALID", where + ": " + what,
                    "correct the camera, or let lumi estimate it from the photographs");
    };
    if (camera.width_px <= 0 || camera.height_px <= 0) refuse("expected a positive image size");
    if (camera.parameters.size() != parameter_count(camera.model)) {
        refuse("expected " + std::to_string(parameter_count(camera.model)) + " parameters for " +
               std::string(name_of(camera.model)) + ", found " +
               std::to_string(camera.parameters.size()));
    }
    for (const double parameter : camera.parameters) {
        if (!std::isfinite(parameter)) refuse("a parameter is not a finite number");
    }
    if (focal_length_px(camera).minCoeff() <= 0) refuse("expected a positive focal length");
}

std::optional<Eigen::Vector2d> project(const Camera& camera, const Eigen::Vector3d& point_in_cam) {
    if (!(point_in_cam.z() > kMinDepth)) return std::nullopt;
    const Eigen::Vector2d at_depth_one = point_in_cam.head<2>() / point_in_cam.z();
    return principal_point_px(camera) +
           focal_length_px(camera).cwiseProduct(distort(camera, at_depth_one));
}

Eigen::Vector3d unproject(const Camera& camera, const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d distorted =
        (pixel - principal_point_px(camera)).cwiseQuotient(focal_length_px(camera));
    Eigen::Vector2d point = distorted;
    if (!is_pinhole(camera)) {
        constexpr int kMaxIterations = 50;
        for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
            const Eigen::Vector2d residual = distort(camera, point) - distorted;
            const Eigen::Vector2d step =
                distortion_jacobian(camera, point).partialPivLu().solve(residual);
            if (!step.allFinite()) break;
            point -= step;
            if (step.norm() < 1e-14) break;
        }
    }
    return point.homogeneous();
}

}  // namespace lumi
