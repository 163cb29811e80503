#pragma once

#include <functional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Draws the pictures from the Lumigraph of the views that were not kept back, which have their
/// depth meshes (make_depth_meshes).
using KeptBackVisitor =
    std::function<void(Lumigraph& others, const std::vector<PicturedEye>& pictures)>;

/// Asks a Lumigraph's own photographs: every sixth of its views is kept back, to be drawn from the
/// others in evened exposures, no larger than 1280 pixels; no more than twelve at once; again with
/// other views, until there were eight pictures. Returns how many there were; 0 for fewer than
/// eight views, of which nobody is asked: with eight, each is. `capture.views` lists the
/// Lumigraph's views in the same order. `step` is what progress says. Throws what `visit` throws.
std::size_t visit_kept_back(const Lumigraph& lumigraph, const Capture& capture,
                            const CameraMeshOptions& mesh_options, const std::string& step,
                            Progress& progress, const KeptBackVisitor& visit);

}  // namespace lumi
