#pragma once

#include <functional>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Of fewer views nothing is kept back: what is left would tell of another capture.
inline constexpr std::size_t kLeastViewsToKeepBackFrom = 8;

/// Draws the pictures from the Lumigraph of the views that were not kept back.
using KeptBackVisitor =
    std::function<void(Lumigraph& others, const std::vector<PicturedEye>& pictures)>;

/// Asks a Lumigraph's own photographs: every sixth of its views is kept back, to be drawn from the
/// others in evened exposures, no larger than 1280 pixels; again with other views, three times at
/// most, until there were eight pictures. Returns how many there were; 0 for fewer than eight
/// views. `capture.views` lists the Lumigraph's views in the same order. Throws what `visit`
/// throws.
std::size_t visit_kept_back(const Lumigraph& lumigraph, const Capture& capture,
                            const CameraMeshOptions& mesh_options, const KeptBackVisitor& visit);

}  // namespace lumi
