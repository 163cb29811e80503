#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// A photograph whose place is known.
struct View {
    std::string name;      ///< As in the photographs' folder, with '/' between folders; unique.
    int camera_index = 0;  ///< Into Capture::cameras.
    Rigid3 cam_from_world;
};

/// A scene point was seen at a pixel of a view.
struct Observation {
    int view_index = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

/// A triangulated point of the scene.
struct ScenePoint {
    Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
    Rgb8 color;
    double error_px = 0.0;  ///< Mean reprojection error over its track.
    std::vector<Observation> track;
};

/// What was photographed, from where: the value that `calib` hands on.
/// Views are sorted by name; indices refer to these vectors.
struct Capture {
    std::vector<Camera> cameras;
    std::vector<View> views;
    std::vector<ScenePoint> points;
};

[[nodiscard]] inline const Camera& camera_of(const Capture& capture, const View& view) {
    return capture.cameras[static_cast<std::size_t>(view.camera_index)];
}

/// Throws Error (E-CAPTURE-INVALID) unless every number is finite, every index in range, every
/// rotation of unit length and every name unique and non-empty; `where` begins the message.
void validate(const Capture& capture, const std::string& where);

}  // namespace lumi
