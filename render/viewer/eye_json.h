#pragma once

#include <nlohmann/json.hpp>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// An eye as screenshots and paths hold it: its camera and where it stands.
[[nodiscard]] inline nlohmann::ordered_json eye_json(const Eye& eye) {
    const Eigen::Quaterniond& q = eye.cam_from_world.rotation;
    const Eigen::Vector3d& t = eye.cam_from_world.translation;
    return {{"camera",
             {{"model", name_of(eye.camera.model)},
              {"width_px", eye.camera.width_px},
              {"height_px", eye.camera.height_px},
              {"parameters", eye.camera.parameters}}},
            {"cam_from_world",
             {{"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
              {"translation", {t.x(), t.y(), t.z()}}}}};
}

}  // namespace lumi
