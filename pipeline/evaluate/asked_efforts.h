#pragma once

#include "calib/capture/capture.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/config/build_config.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How closely a package's depth meshes are to follow noisy depth: as `wanted` says, where it does;
/// else as photographs want it, which is noted; where nothing can be drawn here to ask them, as by
/// default. `capture.views` lists the Lumigraph's views in the same order. Throws Error
/// (E-INTERRUPTED).
[[nodiscard]] DepthMeshEffort asked_depth_mesh_effort(const Lumigraph& lumigraph,
                                                      const Capture& capture,
                                                      const CameraMeshOptions& mesh_options,
                                                      const DrawingOptions& wanted,
                                                      Progress& progress);

/// The same for all else that photographs choose, each with what was chosen before it.
[[nodiscard]] DrawingEfforts asked_drawing_efforts(const Lumigraph& lumigraph,
                                                   const Capture& capture,
                                                   const CameraMeshOptions& mesh_options,
                                                   const DrawingOptions& wanted,
                                                   Progress& progress);

}  // namespace lumi
