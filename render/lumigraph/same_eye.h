#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Whether two eyes see the same picture, to the last bit.
[[nodiscard]] inline bool is_same_eye(const Eye& a, const Eye& b) {
    return a.camera == b.camera &&
           a.cam_from_world.rotation.coeffs() == b.cam_from_world.rotation.coeffs() &&
           a.cam_from_world.translation == b.cam_from_world.translation;
}

}  // namespace lumi
