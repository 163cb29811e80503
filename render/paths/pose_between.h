#pragma once

#include "calib/capture/rigid3.h"

namespace lumi {

/// The pose at a share of the way from one (0) to another (1): the centre runs straight, the
/// rotation turns evenly.
[[nodiscard]] Rigid3 pose_between(const Rigid3& from, const Rigid3& to, double share);

}  // namespace lumi
