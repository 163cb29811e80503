#pragma once

#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

struct TwoPlaneOptions {
    int columns = 6;    ///< Of eye points, > 1.
    int rows = 5;       ///< > 1.
    int size_px = 256;  ///< Of the square pictures.
};

/// A slab of the two-plane parameterisation (Levoy, Hanrahan 1996; Gortler et al. 1996), as the
/// paper compares with: eye points on a regular grid of one plane, over the extent of the source's
/// cameras; all pictures cover the same square of a parallel plane through the scene's centre, as
/// sheared perspective views.
[[nodiscard]] LightFieldLayout two_plane_slab(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

/// Six slabs around the scene: the camera mesh is a cube with a grid of `columns` squared eye
/// points on each side. `source` has cameras all around.
[[nodiscard]] LightFieldLayout two_plane_cube(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

}  // namespace lumi
