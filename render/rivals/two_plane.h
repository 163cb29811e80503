#pragma once

#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

struct TwoPlaneOptions {
    int columns = 6;     ///< Of eye points, > 1.
    int rows = 5;        ///< > 1.
    int width_px = 256;  ///< Of the pictures.
    int height_px = 256;
};

/// About so many eye points over the extent of the source's cameras, as far apart in columns as in
/// rows. The pictures' size is left as it is in `options`.
[[nodiscard]] TwoPlaneOptions with_even_grid(const Lumigraph& source, std::size_t pictures,
                                             TwoPlaneOptions options);

/// A slab of the two-plane parameterisation (Levoy, Hanrahan 1996; Gortler et al. 1996), as the
/// paper compares with: eye points on a regular grid of one plane, over the extent of the source's
/// cameras; all pictures cover the same rectangle of a parallel plane through the scene's centre,
/// as much as the median photograph shows of it (seen_half_size), as sheared perspective views.
[[nodiscard]] LightFieldLayout two_plane_slab(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

/// Six slabs around the scene: the camera mesh is a cube with a grid of `columns` squared eye
/// points on each side. `source` has cameras all around. As the sides stand in no frame of the
/// photographs, the pictures are squares, of as many pixels and as large an area as is asked for.
[[nodiscard]] LightFieldLayout two_plane_cube(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

}  // namespace lumi
