#include "meshing/cameras/line_strip.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace lumi {
namespace {

constexpr double kPi = std::numbers::pi;

/// How far above and below the plane a camera is repeated, in units of its distance: rays up to
/// about 80 degrees off the plane find the strip.
constexpr double kHeightOverRadius = 6.0;
constexpr double kEndStepRad = kPi / 6;
/// What stays open of a full turn behind an open row.
constexpr double kOpeningRad = kPi / 9;

/// Normal of the plane through the scene centre that the directions lie closest to. One direction,
/// or two opposite ones, leave it free: any plane through them will do.
Eigen::Vector3d plane_normal(const std::vector<CameraDirection>& cameras) {
    Eigen::Matrix3Xd directions(3, cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        directions.col(static_cast<Eigen::Index>(i)) = cameras[i].direction;
    }
    const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(directions, Eigen::ComputeFullU);
    if (svd.singularValues().size() < 2 || svd.singularValues()(1) < 1e-9) {
        return orthogonal_unit(cameras.front().direction);
    }
    return svd.matrixU().col(2);
}

double azimuth_rad(const Eigen::Vector3d& direction, const Eigen::Vector3d& forward,
                   const Eigen::Vector3d& normal) {
    return std::atan2(direction.dot(normal.cross(forward)), direction.dot(forward));
}

/// Orders the cameras by azimuth, beginning behind the widest gap, and returns that gap.
double order_by_azimuth(const std::vector<CameraDirection>& cameras, CameraRow& row) {
    const Eigen::Vector3d& first = cameras.front().direction;
    Eigen::Vector3d forward = first - first.dot(row.normal) * row.normal;
    forward =
        forward.norm() > 1e-9 ? Eigen::Vector3d(forward.normalized()) : orthogonal_unit(row.normal);
    std::vector<double> azimuths;
    for (const CameraDirection& camera : cameras) {
        azimuths.push_back(azimuth_rad(camera.direction, forward, row.normal));
    }
    row.order.resize(cameras.size());
    std::iota(row.order.begin(), row.order.end(), std::size_t{0});
    std::stable_sort(row.order.begin(), row.order.end(),
                     [&](std::size_t a, std::size_t b) { return azimuths[a] < azimuths[b]; });

    const std::size_t count = row.order.size();
    std::size_t behind_gap = 0;
    double widest_gap = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double here = azimuths[row.order[i]];
        const double before = azimuths[row.order[(i + count - 1) % count]];
        const double gap = i == 0 ? here - before + 2 * kPi : here - before;
        if (gap > widest_gap) {
            widest_gap = gap;
            behind_gap = i;
        }
    }
    std::rotate(row.order.begin(), row.order.begin() + static_cast<std::ptrdiff_t>(behind_gap),
                row.order.end());
    for (const std::size_t camera : row.order) {
        double azimuth = azimuths[camera];
        if (!row.azimuths_rad.empty() && azimuth < row.azimuths_rad.front()) azimuth += 2 * kPi;
        row.azimuths_rad.push_back(azimuth);
    }
    return widest_gap;
}

double rms_height_rad(const std::vector<CameraDirection>& cameras, const Eigen::Vector3d& normal) {
    double sum = 0;
    for (const CameraDirection& camera : cameras) {
        const double height = std::asin(std::clamp(camera.direction.dot(normal), -1.0, 1.0));
        sum += height * height;
    }
    return std::sqrt(sum / static_cast<double>(cameras.size()));
}

/// A strip under construction: pairs of vertices, joined to the pair before.
class StripBuilder {
 public:
    StripBuilder(CameraMesh& mesh, const Eigen::Vector3d& normal) : mesh_(mesh), normal_(normal) {}

    void add_pair(const Eigen::Vector3d& position, double height, int view_index) {
        mesh_.vertices.push_back({position + height * normal_, view_index});
        mesh_.vertices.push_back({position - height * normal_, view_index});
        if (pairs_ > 0) join(pairs_ - 1, pairs_);
        ++pairs_;
    }
    void close() { join(pairs_ - 1, 0); }

 private:
    /// With azimuth growing counter-clockwise about the normal, these wind counter-clockwise seen
    /// from outside.
    void join(int from, int to) {
        const int upper_from = 2 * from;
        const int lower_from = upper_from + 1;
        const int upper_to = 2 * to;
        const int lower_to = upper_to + 1;
        mesh_.faces.push_back({upper_from, lower_from, upper_to});
        mesh_.faces.push_back({upper_to, lower_from, lower_to});
    }

    CameraMesh& mesh_;
    Eigen::Vector3d normal_;
    int pairs_ = 0;
};

}  // namespace

std::optional<CameraRow> find_row(const std::vector<CameraDirection>& cameras, bool forced) {
    CameraRow row;
    row.normal = plane_normal(cameras);
    const double widest_gap = order_by_azimuth(cameras, row);
    const std::size_t count = cameras.size();
    if (count <= 2) return row;

    const double extent_rad = row.azimuths_rad.back() - row.azimuths_rad.front();
    const double spacing_rad = extent_rad / static_cast<double>(count - 1);
    constexpr double kMaxHeightOverSpacing = 0.5;
    if (!forced && rms_height_rad(cameras, row.normal) > kMaxHeightOverSpacing * spacing_rad) {
        return std::nullopt;
    }
    constexpr double kMaxRingGapRad = 2 * kPi / 3;
    row.ring = widest_gap < kMaxRingGapRad;
    return row;
}

CameraMesh strip_of_row(const CameraRow& row, const std::vector<CameraDirection>& cameras,
                        const Eigen::Vector3d& scene_centre_in_world) {
    CameraMesh mesh;
    mesh.construction = MeshConstruction::kLine;
    mesh.scene_centre_in_world = scene_centre_in_world;
    StripBuilder strip(mesh, row.normal);

    const auto add_turned = [&](const CameraDirection& camera, double turn_rad) {
        const Eigen::Vector3d turned =
            Eigen::AngleAxisd(turn_rad, row.normal) * (camera.radius * camera.direction);
        strip.add_pair(scene_centre_in_world + turned, kHeightOverRadius * camera.radius,
                       camera.view_index);
    };
    const double extent_rad = row.azimuths_rad.back() - row.azimuths_rad.front();
    const double free_rad = row.ring ? 0 : std::max(0.0, 2 * kPi - kOpeningRad - extent_rad);
    const int end_steps = static_cast<int>(std::ceil(0.5 * free_rad / kEndStepRad));
    const double end_step_rad = end_steps > 0 ? 0.5 * free_rad / end_steps : 0;

    const CameraDirection& first = cameras[row.order.front()];
    const CameraDirection& last = cameras[row.order.back()];
    for (int step = end_steps; step > 0; --step) add_turned(first, -step * end_step_rad);
    for (const std::size_t index : row.order) add_turned(cameras[index], 0);
    for (int step = 1; step <= end_steps; ++step) add_turned(last, step * end_step_rad);
    if (row.ring) strip.close();
    return mesh;
}

}  // namespace lumi
