#pragma once

#include "render/rivals/resampled_lumigraph.h"

namespace lumi {

struct SphericalOptions {
    int subdivisions = 1;  ///< Of an icosahedron: 12, 42, 162, 642 directions.
    int size_px = 256;     ///< Of the square pictures.
};

/// Those whose number of directions is nearest to this many.
[[nodiscard]] int subdivisions_for(std::size_t pictures);

/// A sphere-plane light field (Camahort, Lerios, Fussell 1998; the paper's "spherical" rivals): one
/// parallel picture of the scene for each of many even directions, of a square as large as what the
/// median photograph shows (seen_half_size). Parallel projection is approached by eyes that stand
/// twenty times half its side away. They share no plane: without depth they are looked up on the
/// scene plane (scene_plane.h).
[[nodiscard]] LightFieldLayout spherical_light_field(const Lumigraph& source,
                                                     const SphericalOptions& options);

}  // namespace lumi
