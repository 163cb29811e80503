#pragma once

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Where an eye stands among the cameras of a Lumigraph.
enum class ViewPlace {
    kInterior,  ///< Most of its rays are blended between cameras.
    kBorder,    ///< Most of them are continued beyond the outermost cameras.
};

/// Judged by a grid of rays over the eye's picture: a ray is interior when the face it crosses has
/// three different cameras (two where cameras stand in a row). Without faces all are where the eye
/// is no farther from a camera than the loneliest camera is from its next.
[[nodiscard]] ViewPlace place_of_view(const CameraMesh& mesh, const Camera& camera,
                                      const Rigid3& cam_from_world);

}  // namespace lumi
