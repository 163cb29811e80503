#pragma once

#include <vector>

#include "calib/capture/capture.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The Lumigraph of some of its views alone: the camera mesh is made anew over them. `views` are
/// indices into `lumigraph.views`, ascending, which `capture.views` lists in the same order.
[[nodiscard]] Lumigraph lumigraph_of_views(const Lumigraph& lumigraph, const Capture& capture,
                                           const std::vector<int>& views,
                                           const CameraMeshOptions& mesh_options);

/// The `count` views of the capture that stand for all of them best; all when there are no more.
[[nodiscard]] std::vector<int> representative_views_of(const Capture& capture, int count);

/// What the pictures of these views take in a GL's memory, MiB: four bytes a pixel of colour and
/// four of depth.
[[nodiscard]] double texture_mib(const Lumigraph& lumigraph, const std::vector<int>& views);

}  // namespace lumi
