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
    [[nodiscard]] double explained() const {
        const Eigen::LDLT<Eigen::Matrix<double, kParameters, kParameters>> solver(normal);
        if (rows < 4 * kParameters || solver.info() != Eigen::Success) return 0.0;
        return moment.dot(solver.solve(moment));
    }
};

template <int kParameters>
double variance_ratio(const std::vector<Regression<kParameters>>& views) {
    double explained = 0;
    double left = 0;
    int rows = 0;
    int parameters = 0;
    for (const Regression<kParameters>& view : views) {
        if (view.rows < 4 * kParameters) continue;
        explained += view.explained();
        left += view.square - view.explained();
        rows += view.rows;
        parameters += kParameters;
    }
    if (parameters == 0 || rows <= parameters || !(left > 0)) return 1.0;
    return (explained / parameters) / (left / (rows - parameters));
}

}  // namespace

ResidualPattern residual_pattern(const Capture& capture) {
    std::vector<Regression<3>> shutter(capture.views.size());
    std::vector<Regression<1>> zoom(capture.views.size());
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const auto index = static_cast<std::size_t>(seen.view_index);
            const View& view = capture.views[index];
            const Camera& camera = camera_of(capture, view);
            const Eigen::Vector3d in_cam = view.cam_from_world * point.position_in_world;
            const auto pixel = project(camera, in_cam);
            if (!pixel) continue;
            const Eigen::Vector2d residual = seen.pixel - *pixel;
            // A small turn moves the point by turn x point; distortion matters little to the slope.
            const double x = in_cam.x() / in_cam.z();
            const double y = in_cam.y() / in_cam.z();
            const Eigen::Vector2d focal = focal_length_px(camera);
            Eigen::Matrix<double, 2, 3> by_turn;
            by_turn << -x * y, 1 + x * x, -y, -(1 + y * y), x * y, x;
            by_turn.row(0) *= focal.x();
            by_turn.row(1) *= focal.y();
            const double time = seen.pixel.y() / camera.height_px - 0.5;
            shutter[index].add(time * by_turn, residual);
            zoom[index].add(*pixel - principal_point_px(camera), residual);
        }
    }
    return {variance_ratio(shutter), variance_ratio(zoom)};
}

std::size_t count_observations(const Capture& capture) {
    std::size_t count = 0;
    for (const ScenePoint& point : capture.points) count += point.track.size();
    return count;
}

double truncated_cost_px2(const Capture& capture, std::size_t observations, double limit_px) {
    double cost = 0;
    std::size_t counted = 0;
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            const auto pixel =
                project(camera_of(capture, view), view.cam_from_world * point.position_in_world);
            const double square = pixel ? (*pixel - seen.pixel).squaredNorm() : limit_px * limit_px;
            cost += std::min(square, limit_px * limit_px);
            ++counted;
        }
    }
    const auto dropped = static_cast<double>(observations - std::min(observations, counted));
    return cost + dropped * limit_px * limit_px;
}

bool explains_better(double cost_px2, double richer_cost_px2, int more_parameters,
                     std::size_t observations) {
    const double rows = 2.0 * static_cast<double>(observations);
    if (!(richer_cost_px2 > 0) || rows < 2) return false;
    return rows * std::log(cost_px2 / richer_cost_px2) > more_parameters * std::log(rows);
}

}  // namespace lumi
