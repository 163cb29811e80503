#pragma once

#include "calib/work/progress.h"
#include "render/rivals/rival_methods.h"

namespace lumi {

/// What a rival draws from, as a Lumigraph.
struct ResampledPictures {
    Lumigraph lumigraph;
    FocalPlane shared_plane{};  ///< LightFieldLayout::shared_plane.

    /// The options, in `lightfield` on the shared plane, where there is one.
    [[nodiscard]] RenderOptions on_shared_plane(RenderOptions options) const;
};

/// The pictures that a rival's parameterisation asks for (resampled_lumigraph.h), drawn from the
/// Lumigraph in the mode `perpixel`. The rival can be drawn from it (ResampledRival). Throws Error
/// (E-GL-..., E-INTERRUPTED).
[[nodiscard]] ResampledPictures resampled_pictures(const ResampledRival& rival,
                                                   const Lumigraph& lumigraph,
                                                   const Progress& progress);

}  // namespace lumi
