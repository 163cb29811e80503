#pragma once

#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How far the triangles of `adaptive` may err before photographs that are kept back can tell
/// (kept_back_rounds.h): the largest error asked with which they are drawn as well as with any
/// other, but for what nobody sees; and whether what is thinner is to be drawn over them: where
/// that gains more than one standard error, and than what nobody sees. For fewer than eight views
/// nobody is asked. `capture.views` lists the Lumigraph's views in the same order. Throws Error
/// (E-GL-...).
[[nodiscard]] TriangleEffort sufficient_triangle_effort(const Lumigraph& lumigraph,
                                                        const Capture& capture,
                                                        const CameraMeshOptions& mesh_options,
                                                        Progress& progress);

}  // namespace lumi
