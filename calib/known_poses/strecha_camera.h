#pragma once

#include <filesystem>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// A camera of Strecha's multi-view benchmark (CVPR 2008).
struct StrechaCamera {
    Camera camera;  ///< LensModel::kPinhole at the size that the file states.
    Rigid3 cam_from_world;
};

/// Reads K (three rows), a distortion line, the rotation world-from-camera (three rows), the centre
/// in world units, and the picture size. Throws Error: E-IMPORT-STRECHA (not
/// such a file), E-IMPORT-POSES (K or the rotation is none), E-CAMERA-INVALID.
[[nodiscard]] StrechaCamera read_strecha_camera(const std::filesystem::path& path);

}  // namespace lumi
