#include "calib/adjust/linearisation.h"

#include <algorithm>
#include <utility>

#include "calib/adjust/bundle_problem.h"
#include "calib/adjust/camera_blocks.h"
#include "calib/adjust/reprojection_cost.h"

namespace lumi {

UnknownsLayout unknowns_layout(const Capture& capture, const BundleAdjustmentOptions& options) {
    UnknownsLayout layout;
    layout.pose_of_view.assign(capture.views.size(), -1);
    std::vector<char> is_seen(capture.views.size(), 0);
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            is_seen[static_cast<std::size_t>(seen.view_index)] = 1;
        }
    }
    std::vector<char> is_used(capture.cameras.size(), 0);
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        if (is_seen[view] == 0) continue;
        layout.pose_of_view[view] = layout.unknowns;
        layout.unknowns += 6;
        is_used[static_cast<std::size_t>(capture.views[view].camera_index)] = 1;
    }
    for (std::size_t camera = 0; camera < capture.cameras.size(); ++camera) {
        const std::size_t count = capture.cameras[camera].parameters.size();
        std::vector<Eigen::Index> unknowns(count, -1);
        const std::vector<int> held = constant_lens_parameters(capture, camera, options);
        for (std::size_t index = 0; index < count && is_used[camera] != 0; ++index) {
            if (!std::binary_search(held.begin(), held.end(), static_cast<int>(index))) {
                unknowns[index] = layout.unknowns++;
            }
        }
        layout.lens_unknowns.push_back(std::move(unknowns));
    }
    return layout;
}

bool Linearisation::at(const ScenePoint& point, const Observation& seen,
                       LinearisedSight& result) const {
    const auto view_index = static_cast<std::size_t>(seen.view_index);
    const View& view = capture_.views[view_index];
    const Camera& lens = camera_of(capture_, view);
    const Rigid3& pose = view.cam_from_world;
    const PoseBlock pose_values = pose_block(pose);
    const std::array<const double*, 3> blocks{lens.parameters.data(), pose_values.data(),
                                              point.position_in_world.data()};
    std::array<double, 2 * 12> by_lens{};
    Eigen::Matrix<double, 2, 7, Eigen::RowMajor> by_pose;
    std::array<double*, 3> jacobians{by_lens.data(), by_pose.data(), nullptr};
    if (!reprojection_cost(lens.model, seen.pixel)
             ->Evaluate(blocks.data(), result.residual_px.data(), jacobians.data())) {
        return false;
    }
    const Eigen::Matrix<double, 2, 3> by_translation = by_pose.rightCols<3>();
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    const Eigen::Vector3d rotated = rotation * point.position_in_world;
    Eigen::Matrix3d by_turn;  // Of `rotated`, by a rotation that comes after.
    by_turn << 0, rotated.z(), -rotated.y(), -rotated.z(), 0, rotated.x(), rotated.y(),
        -rotated.x(), 0;
    result.by_point = by_translation * rotation;

    const auto camera_index = static_cast<std::size_t>(view.camera_index);
    const std::vector<Eigen::Index>& lens_unknowns = layout_.lens_unknowns[camera_index];
    const std::size_t count = lens_unknowns.size();
    Eigen::Index columns = 6;
    for (const Eigen::Index unknown : lens_unknowns) columns += unknown >= 0 ? 1 : 0;
    result.by_camera.resize(2, columns);
    result.by_camera.leftCols<3>() = by_translation * by_turn;
    result.by_camera.middleCols<3>(3) = by_translation;
    for (Eigen::Index column = 0; column < 6; ++column) {
        result.unknowns[static_cast<std::size_t>(column)] =
            layout_.pose_of_view[view_index] + column;
    }
    Eigen::Index column = 6;
    for (std::size_t index = 0; index < count; ++index) {
        if (lens_unknowns[index] < 0) continue;
        result.by_camera(0, column) = by_lens[index];
        result.by_camera(1, column) = by_lens[count + index];
        result.unknowns[static_cast<std::size_t>(column++)] = lens_unknowns[index];
    }
    return true;
}

}  // namespace lumi
