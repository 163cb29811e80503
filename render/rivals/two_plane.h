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
/// This is the plane that they are looked up on without depth (shared_plane), so that a ray has the
/// same four coordinates from wherever it is seen. Between eye points it has the weights of the
/// triangles that the grid's squares are halved to, where both papers interpolate in squares.
[[nodiscard]] LightFieldLayout two_plane_slab(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

/// Six slabs around the scene: the camera mesh is a cube with a grid of `columns` squared eye
/// points on each side. `source` has cameras all around. Each slab has a plane of its own through
/// the scene's centre, so that they share none: without depth they are looked up on the scene plane
/// (scene_plane.h), which turns with the eye, where the papers look up on the slab's. As the sides
/// stand in no frame of the photographs, the pictures are squares, of as many pixels and as large
/// an area as is asked for.
[[nodiscard]] LightFieldLayout two_plane_cube(const Lumigraph& source,
                                              const TwoPlaneOptions& options);

}  // namespace lumi
