#pragma once

#include "render/lumigraph/lumigraph.h"
#include "render/modes/frame.h"

namespace lumi {

/// The method in plain code: what the GL modes are tested against. Slow and clear. Modes: all.
[[nodiscard]] Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye,
                                   const RenderOptions& options);

}  // namespace lumi
