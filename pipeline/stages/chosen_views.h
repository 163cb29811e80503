#pragma once

#include <vector>

#include "calib/capture/capture.h"
#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/surface/pictured_view.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The Lumigraph of some of its views alone: the camera mesh is made anew over them. `views` are
/// indices into `lumigraph.views`, ascending, which `capture.views` lists in the same order.
[[nodiscard]] Lumigraph lumigraph_of_views(const Lumigraph& lumigraph, const Capture& capture,
                                           const std::vector<int>& views,
                                           const CameraMeshOptions& mesh_options);

/// Of the Lumigraph's views, which must be in the order of the photographs: names lead back to
/// these when some were left out.
[[nodiscard]] Capture capture_of(const Lumigraph& lumigraph, const PosedPhotographs& photographs);

/// What measurements on photographs need of each view of the Lumigraph, which must outlive it.
[[nodiscard]] std::vector<PicturedView> pictured_views(const Lumigraph& lumigraph);

/// The listed views, the one that is missed most first (view_worth.h), in evened exposures: a
/// photograph is not to be missed for how it was exposed. `views` and `capture` as above.
[[nodiscard]] std::vector<int> views_by_worth(const Lumigraph& lumigraph, const Capture& capture,
                                              const std::vector<int>& views, int threads,
                                              const Progress& progress);

/// The first `count` of them, ascending; all when there are no more.
[[nodiscard]] std::vector<int> most_worthy_views(const std::vector<int>& by_worth, int count);

/// What the pictures of these views take in a GL's memory, MiB: four bytes a pixel of colour and
/// four of depth.
[[nodiscard]] double texture_mib(const Lumigraph& lumigraph, const std::vector<int>& views);

}  // namespace lumi
