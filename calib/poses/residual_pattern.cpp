#include "calib/poses/residual_pattern.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace lumi {
namespace {

/// The normal equations of one view's regression.
template <int kParameters>
struct Regression {
    Eigen::Matrix<double, kParameters, kParameters> normal =
        Eigen::Matrix<double, kParameters, kParameters>::Zero();
    Eigen::Matrix<double, kParameters, 1> moment = Eigen::Matrix<double, kParameters, 1>::Zero();
    double square = 0.0;
    int rows = 0;

    void add(const Eigen::Matrix<double, 2, kParameters>& slope, const Eigen::Vector2d& residual) {
        normal += slope.transpose() * slope;
        moment += slope.transpose() * residual;
        square += residual.squaredNorm();
        rows += 2;
    }
    [[nodiscard]] bool is_usable() const { return rows >= 4 * kParameters; }
    /// The squares that the first parameters take away.
    [[nodiscard]] double explained_by_first(int count) const {
        if (count == 0) return 0.0;
        const Eigen::LDLT<Eigen::MatrixXd> solver(normal.topLeftCorner(count, count));
        if (solver.info() != Eigen::Success) return 0.0;
        return moment.head(count).dot(solver.solve(moment.head(count)));
    }
};

/// Of the parameters after the first `given`, which are free in any case.
template <int kParameters>
double variance_ratio(const std::vector<Regression<kParameters>>& views, int given) {
    double explained = 0;
    double left = 0;
    int rows = 0;
    int parameters = 0;
    for (const Regression<kParameters>& view : views) {
        if (!view.is_usable()) continue;
        const double by_all = view.explained_by_first(kParameters);
        explained += by_all - view.explained_by_first(given);
        left += view.square - by_all;
        rows += view.rows - given;
        parameters += kParameters - given;
    }
    if (parameters == 0 || rows <= parameters || !(left > 0)) return 1.0;
    return (explained / parameters) / (left / (rows - parameters));
}

/// How the picture of a point, in focal lengths, moves with the camera: the first three columns by
/// a turn about its axes (a small one moves the point by turn x point), the others by a step along
/// them. Distortion matters little to the slope.
Eigen::Matrix<double, 2, 6> slope_by_pose(const Eigen::Vector3d& in_cam) {
    const double x = in_cam.x() / in_cam.z();
    const double y = in_cam.y() / in_cam.z();
    const double nearness = 1 / in_cam.z();
    Eigen::Matrix<double, 2, 6> slope;
    slope << -x * y, 1 + x * x, -y, nearness, 0, -x * nearness,  //
        -(1 + y * y), x * y, x, 0, nearness, -y * nearness;
    return slope;
}

}  // namespace

ResidualPattern residual_pattern(const Capture& capture) {
    std::vector<Regression<3>> shutter(capture.views.size());
    std::vector<Regression<7>> zoom(capture.views.size());
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const auto index = static_cast<std::size_t>(seen.view_index);
            const View& view = capture.views[index];
            const Camera& camera = camera_of(capture, view);
            const Eigen::Vector3d in_cam = view.cam_from_world * point.position_in_world;
            const auto pixel = project(camera, in_cam);
            if (!pixel) continue;
            const Eigen::Vector2d residual = seen.pixel - *pixel;
            const Eigen::Matrix<double, 2, 6> by_pose =
                focal_length_px(camera).asDiagonal() * slope_by_pose(in_cam);
            const double time = seen.pixel.y() / camera.height_px - 0.5;
            shutter[index].add(time * by_pose.leftCols<3>(), residual);
            Eigen::Matrix<double, 2, 7> by_pose_and_zoom;
            by_pose_and_zoom << by_pose, *pixel - principal_point_px(camera);
            zoom[index].add(by_pose_and_zoom, residual);
        }
    }
    return {variance_ratio(shutter, 0), variance_ratio(zoom, 6)};
}

bool explains_better(double cost_px2, double richer_cost_px2, int more_parameters,
                     std::size_t observations) {
    const double rows = 2.0 * static_cast<double>(observations);
    if (!(richer_cost_px2 > 0) || rows < 2) return false;
    return rows * std::log(cost_px2 / richer_cost_px2) > more_parameters * std::log(rows);
}

}  // namespace lumi
