#pragma once

#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

struct SphericalOptions {
    int subdivisions = 1;  ///< Of an icosahedron: 12, 42, 162, 642 directions.
    int size_px = 256;     ///< Of the square pictures.
};

/// A sphere-plane light field (Camahort, Lerios, Fussell 1998; the paper's "spherical" rivals): one
/// parallel picture of the whole scene for each of many even directions. Parallel projection is
/// approached by eyes that stand twenty scene radii away.
[[nodiscard]] LightFieldLayout spherical_light_field(const Lumigraph& source,
                                                     const SphericalOptions& options);

}  // namespace lumi
