#pragma once

#include "calib/work/progress.h"
#include "render/rivals/rival_methods.h"

namespace lumi {

/// The pictures that a rival's parameterisation asks for (resampled_lumigraph.h), drawn from the
/// Lumigraph in the mode `perpixel`. The rival can be drawn from it (ResampledRival). Throws Error
/// (E-GL-..., E-INTERRUPTED).
[[nodiscard]] Lumigraph resampled_pictures(const ResampledRival& rival, const Lumigraph& lumigraph,
                                           const Progress& progress);

}  // namespace lumi
