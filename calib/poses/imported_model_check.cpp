#include "calib/poses/imported_model_check.h"

#include <cmath>
#include <string>
#include <vector>

#include "calib/capture/one_place.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr double kDeniedShare = 0.005;  // Of a picture's diagonal.

void refuse_one_place(const Capture& capture) {
    if (capture.views.size() < 2) return;
    const Rigid3& first = capture.views.front().cam_from_world;
    for (const View& view : capture.views) {
        if (!are_at_one_place(first, view.cam_from_world)) return;
    }
    throw Error(
        ErrorKind::kBadInput, "E-IMPORT-ONEPLACE",
        "all " + std::to_string(capture.views.size()) + " imported cameras stand at one place",
        "check that the other program exported places beside directions, or let lumi "
        "estimate the poses");
}

/// By the points that came with the poses.
void refuse_own_points(const Capture& capture) {
    constexpr std::size_t kLeastObservations = 50;
    std::size_t behind = 0;
    std::vector<double> off_by;  // Of what is denied.
    for (const ScenePoint& point : capture.points) {
        for (const Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            const Camera& camera = camera_of(capture, view);
            const auto pixel = project(camera, view.cam_from_world * point.position_in_world);
            if (!pixel)
                ++behind;
            else
                off_by.push_back((*pixel - seen.pixel).norm() / denied_error_px(camera));
        }
    }
    const std::size_t observations = behind + off_by.size();
    if (observations < kLeastObservations) return;
    if (2 * behind > observations) {
        refuse_imported_poses(
            std::to_string(behind) + " of " + std::to_string(observations) +
            " times that the imported model says a camera sees a point, the point lies "
            "behind it");
    }
    const double off = median_of(std::move(off_by));
    if (off > 1) {
        refuse_imported_poses(
            formatted("half of the imported points lie %.1f %% of a picture's diagonal "
                      "or more beside where the imported model says they are seen",
                      100 * kDeniedShare * off));
    }
}

}  // namespace

double denied_error_px(const Camera& camera) {
    return kDeniedShare *
           std::hypot(static_cast<double>(camera.width_px), static_cast<double>(camera.height_px));
}

void refuse_imported_poses(const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-DENIED", what,
                "give the photographs that the poses were found with, poses in the axes of "
                "their format, or let lumi estimate the poses");
}

void expect_consistent(const Capture& capture) {
    refuse_one_place(capture);
    refuse_own_points(capture);
}

}  // namespace lumi
