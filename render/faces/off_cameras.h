#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The eye that says which views are blended for `eye` where nothing is known but one plane.
///
/// At a camera all other weights are 0. Beyond that camera's photograph the blend would be 0 / 0:
/// its limit depends on the side from which the eye approaches. An eye nearer to a camera than a
/// millionth of the camera's distance from the scene's centre is therefore taken to stand that far
/// behind the camera, seen from the centre; any other eye is returned as it is.
[[nodiscard]] Eye off_cameras(const CameraMesh& mesh, const Eye& eye);

}  // namespace lumi
