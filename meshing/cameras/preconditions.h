#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/cameras/scene_centre.h"

namespace lumi {

/// What a surface between cameras and scene takes (the paper, section 3): that rays cross it once,
/// and that cameras see the scene which it surrounds.
struct SurfacePreconditions {
    double scene_share_in_kernel = 1.0;   ///< Of the scene's points; 1 where none are known.
    double share_that_faces_scene = 1.0;  ///< Of the cameras (`share_that_faces`).
};

/// The share of the cameras in whose pictures the centre lies, hidden or not; inside out, what lies
/// opposite of it.
[[nodiscard]] double share_that_faces(const Capture& capture, const std::vector<OpticalAxis>& axes,
                                      const Eigen::Vector3d& centre_in_world, bool inside_out);

/// The end of a sentence; nothing where both hold for most of the scene and of the cameras.
[[nodiscard]] std::optional<std::string> why_no_surface(const SurfacePreconditions& preconditions);

}  // namespace lumi
