#pragma once

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// A photograph with its place and its depth, as it lies elsewhere.
struct PicturedView {
    const ColorImage* photograph = nullptr;
    Camera camera;  ///< LensModel::kPinhole, the size of `photograph`.
    Rigid3 cam_from_world;
    const DepthMap* depth = nullptr;  ///< Empty images where it is unknown.
};

}  // namespace lumi
