#pragma once

#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How far depth meshes may be from depth maps that tell noise. Where it is noise, meshes that
/// follow it take triangles and time for nothing; where it is a surface as rough as noise, what
/// they leave out is missed. Photographs that are kept back (kept_back_rounds.h) say which: the
/// coarsest, where beside the finest it loses `perpixel` less than anyone sees or than one standard
/// error; else the largest that loses less than anyone sees. With the occlusion tolerance
/// `tolerance_px`; 0: each error with 1.5 or 12 px, whichever suits it better, as the one depends
/// on the other.
///
/// The views must have the depth meshes that the Lumigraph wants (make_depth_meshes). Where none is
/// of noise, nobody is asked; nor for fewer than eight views. `capture.views` lists the Lumigraph's
/// views in the same order. Throws Error (E-GL-...).
[[nodiscard]] DepthMeshEffort sufficient_depth_mesh_effort(const Lumigraph& lumigraph,
                                                           const Capture& capture,
                                                           const CameraMeshOptions& mesh_options,
                                                           double tolerance_px, Progress& progress);

}  // namespace lumi
