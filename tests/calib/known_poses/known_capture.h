#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"
#include "tests/calib/synthetic_capture.h"

namespace lumi {

constexpr int kWidth = 640;
constexpr int kHeight = 480;

inline Camera true_camera() {
    return {kWidth, kHeight, LensModel::kPinhole, {500, 510, 321.5, 238.25}};
}

inline Capture truth(int views = 4) { return synthetic_capture(true_camera(), views, 12); }

/// The photographs of a capture as ingest hands them on: originals of one size, working copies of
/// another.
inline std::vector<Photograph> photographs_of(const Capture& capture, int original_width = kWidth,
                                              int original_height = kHeight,
                                              int copy_width = kWidth, int copy_height = kHeight) {
    std::vector<Photograph> photographs;
    for (const View& view : capture.views) {
        Photograph photograph;
        photograph.name = view.name;
        photograph.original_width_px = original_width;
        photograph.original_height_px = original_height;
        photograph.width_px = copy_width;
        photograph.height_px = copy_height;
        photographs.push_back(photograph);
    }
    return photographs;
}

inline Error refusal(const std::vector<Photograph>& photographs,
                     const std::filesystem::path& poses) {
    try {
        static_cast<void>(import_poses(photographs, {}, poses));
    } catch (const Error& error) {
        return error;
    }
    return {ErrorKind::kUsage, "none", "was not refused", ""};
}

inline void expect_poses(const Capture& found, const Capture& expected, double tolerance) {
    ASSERT_EQ(found.views.size(), expected.views.size());
    for (std::size_t i = 0; i < found.views.size(); ++i) {
        const View& view = found.views[i];
        const Rigid3& truth_pose = expected.views[i].cam_from_world;
        EXPECT_EQ(view.name, expected.views[i].name);
        EXPECT_LT((centre_in_world(view.cam_from_world) - centre_in_world(truth_pose)).norm(),
                  tolerance)
            << view.name;
        EXPECT_LT(view.cam_from_world.rotation.angularDistance(truth_pose.rotation), tolerance)
            << view.name;
    }
}

inline void expect_lens(const Camera& found, const Camera& expected, double tolerance_px) {
    EXPECT_EQ(found.width_px, expected.width_px);
    EXPECT_EQ(found.height_px, expected.height_px);
    EXPECT_LT((focal_length_px(found) - focal_length_px(expected)).norm(), tolerance_px);
    EXPECT_LT((principal_point_px(found) - principal_point_px(expected)).norm(), tolerance_px);
}

struct Axes {
    Eigen::Vector3d right, down, forward, centre;
};

inline Axes axes_of(const View& view) {
    const Eigen::Matrix3d cam_from_world = view.cam_from_world.rotation.toRotationMatrix();
    return {cam_from_world.row(0), cam_from_world.row(1), cam_from_world.row(2),
            centre_in_world(view.cam_from_world)};
}

}  // namespace lumi
