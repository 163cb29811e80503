#pragma once

#include <string>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What people are told where a debug picture is black all over, as it shows what the mode, as it
/// is drawn of this Lumigraph, knows nothing of; else empty.
[[nodiscard]] std::string why_black(const Lumigraph& lumigraph, const RenderOptions& options);

}  // namespace lumi
