#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/surface/camera_mesh.h"
#include "tests/meshing/cameras/synthetic_cameras.h"

namespace lumi {

/// How somebody may have photographed a scene: cameras, which way they look, and scene points.
struct ArrangedCapture {
    std::string name;
    Capture capture;
    Points scene;            ///< Where rays go to in tests: well within what is photographed.
    int least_targets = 50;  ///< Of the 60 that have to lie in the kernel.
    Eigen::Vector3d side =
        Eigen::Vector3d::UnitX();  ///< Rays come from within `spread_deg` of this direction.
    double spread_deg = 180;
    MeshConstruction construction = MeshConstruction::kClosed;
    int cameras_kept = 0;
};

/// One of each kind, hand-held: places off by a few percent where a hand would be.
[[nodiscard]] std::vector<ArrangedCapture> arranged_captures();

}  // namespace lumi
