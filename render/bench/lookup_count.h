#pragma once

#include <optional>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Texture lookups over the pixels of the picture, counted by the shaders themselves
/// (gl/lookup_meter.h). Nothing where the context cannot count.
struct LookupCounts {
    std::optional<double> base_per_pixel;  ///< Of the full-screen blend of three textures.
    std::vector<std::optional<double>> modes_per_pixel;
};

/// Means over some frames of the path. Throws Error (E-GL-...).
[[nodiscard]] LookupCounts count_lookups(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                                         const std::vector<RenderOptions>& modes,
                                         const Progress& progress);

}  // namespace lumi
