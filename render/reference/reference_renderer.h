#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The method in plain code: what the GL modes are tested against. Slow and clear. Modes: all.
[[nodiscard]] Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye,
                                   const RenderOptions& options);

}  // namespace lumi
