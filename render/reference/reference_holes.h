#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/agreed_depth.h"

namespace lumi {

/// What the mode `perpixel` draws over guesses, in plain code: of the cells in which no view that
/// was asked for depth sees the scene (holes/hole_cells.h), what other views do. Covered where
/// these know it.
[[nodiscard]] Frame filled_holes(const Lumigraph& lumigraph, const AgreedDepth& depth,
                                 const Eye& eye, const RenderOptions& options);

}  // namespace lumi
