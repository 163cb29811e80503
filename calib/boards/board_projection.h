#pragma once

#include <ceres/jet.h>
#include <ceres/rotation.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

#include "calib/boards/board_bow.h"
#include "calib/boards/board_views.h"
#include "calib/capture/lens_distortion.h"

namespace lumi {

/// cam_from_board as rotation vector and translation, in pitches: what the solvers move.
using BoardPose = std::array<double, 6>;

/// Pixel of a point in the camera. Unlike the lens models elsewhere the fisheye sees beyond 90
/// degrees, as photographs of boards do. False when the model cannot see the point.
template <LensModel model, class T>
bool project_in_camera(const T* lens, const Eigen::Matrix<T, 3, 1>& point, T* pixel) {
    using std::atan2;
    using std::sqrt;
    Eigen::Matrix<T, 2, 1> px;
    if constexpr (model == LensModel::kOpenCvFisheye) {
        const T r2 = point.x() * point.x() + point.y() * point.y();
        if (r2 > T(1e-16)) {
            const T r = sqrt(r2);
            const T bent = fisheye_radius(T(atan2(r, point.z())), lens + 4);
            px << lens[0] * point.x() * bent / r + lens[2],
                lens[1] * point.y() * bent / r + lens[3];
        } else {
            if (!(point.z() > T(0))) return false;
            px << lens[0] * point.x() / point.z() + lens[2],
                lens[1] * point.y() / point.z() + lens[3];
        }
    } else {
        if (!(point.z() > T(1e-6))) return false;
        px = pixel_of<model>(lens, Eigen::Matrix<T, 2, 1>(point.template head<2>() / point.z()));
    }
    pixel[0] = px.x();
    pixel[1] = px.y();
    return true;
}

/// Pixel where a point of a board is predicted, minus pixel where it was seen. Parameter blocks:
/// lens, size per pitch, BoardPose, and of a bent board BoardBow.
template <LensModel model>
class BoardPointCost {
 public:
    static constexpr int kLens = static_cast<int>(parameter_count(model));

    explicit BoardPointCost(const BoardPoint& point, const BoardFrame& frame = {})
        : point_(point), frame_(frame) {}

    template <class T>
    bool operator()(const T* lens, const T* size, const T* pose, T* residual) const {
        return compare(lens, {x(size), y(size), T(0)}, pose, residual);
    }

    template <class T>
    bool operator()(const T* lens, const T* size, const T* pose, const T* bow, T* residual) const {
        return compare(lens, on_bent_board(x(size), y(size), frame_, bow), pose, residual);
    }

 private:
    template <class T>
    T x(const T* size) const {
        return point_.place.x() + point_.along_size.x() * size[0];
    }
    template <class T>
    T y(const T* size) const {
        return point_.place.y() + point_.along_size.y() * size[0];
    }

    template <class T>
    bool compare(const T* lens, const Eigen::Matrix<T, 3, 1>& on_board, const T* pose,
                 T* residual) const {
        Eigen::Matrix<T, 3, 1> in_camera;
        ceres::AngleAxisRotatePoint(pose, on_board.data(), in_camera.data());
        in_camera += Eigen::Map<const Eigen::Matrix<T, 3, 1>>(pose + 3);
        if (!project_in_camera<model>(lens, in_camera, residual)) return false;
        residual[0] -= point_.px.x();
        residual[1] -= point_.px.y();
        return true;
    }

    BoardPoint point_;
    BoardFrame frame_;
};

}  // namespace lumi
