#pragma once

#include "pipeline/stages/pack_stage.h"

namespace lumi {

/// The fewest that photographs cannot tell from more: of the Lumigraph's own views some are kept
/// back and drawn from the others, no larger than 640 pixels, with either number, and the
/// one-standard-error rule chooses. A further view fills what the others do not see, but may as
/// well be wrong. For fewer than eight views nobody is asked. `capture.views` lists the Lumigraph's
/// views in the same order. Throws Error (E-GL-...).
[[nodiscard]] DepthViewCount sufficient_depth_views(const Lumigraph& lumigraph,
                                                    const Capture& capture,
                                                    const CameraMeshOptions& mesh_options,
                                                    Progress& progress);

}  // namespace lumi
