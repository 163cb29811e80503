#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The eye that says which views are blended for `eye` where nothing is known but one plane.
///
/// At a camera all others have weights of 0, and beyond its photograph ratios of 0 to 0: any that
/// they have beside it, by the side that one comes from. An eye within a millionth of the scene's
/// distance of a camera is taken to stand so far behind it, seen from the scene's centre; others
/// are what they are.
[[nodiscard]] Eye off_cameras(const CameraMesh& mesh, const Eye& eye);

}  // namespace lumi
