#pragma once

#include <cstddef>

#include "calib/capture/camera.h"
#include "meshing/surface/depth_map.h"
#include "render/lumigraph/depth_mesh.h"

namespace lumi {

struct DepthMeshOptions {
    double max_error_px = 0.1;         ///< The mesh follows the depth map this closely.
    double max_coarse_error_px = 0.4;  ///< Allowed instead when there would be too many triangles.
    std::size_t max_triangles = 8'000;
    /// What is filled or stretched is a guess: the mesh follows it so many times less closely.
    double guess_error_ratio = 8.0;
    /// Where a depth map would need more than this even so, its samples tell noise: pairs of rows
    /// and of columns are drawn as one, and the mesh follows these to another error.
    double max_triangles_per_sample = 0.25;
    double max_noisy_error_px = kNoisyDepthError_px;
    /// Vertices are left out as long as that adds no more than this share of the error
    /// (mesh_decimation.h); 0: none is.
    double decimated_share = 0.5;
    double noisy_decimated_share = 1.0;  ///< The same where samples tell noise.
};

/// Whether the samples of the depth map that a mesh was made of told noise.
[[nodiscard]] bool is_of_noise(const DepthMesh& mesh, const DepthMap& depth);

/// The farthest from its depth map that a mesh made for the options may be where it was seen, of
/// noise or not: what they allow, and the share of it that leaving vertices out may add.
[[nodiscard]] double most_error_px(const DepthMeshOptions& options, bool is_of_noise);

/// The coarsest right-triangulated irregular network (Evans, Kirkpatrick, Townsend 2001) that stays
/// within the error: without cracks, and down to single samples along tears and at the edges of
/// what was seen; then without the vertices that it keeps to the error without. The error is that
/// of what was seen; what is filled or stretched errs more. `disparity_px` turns inverse depth into
/// pixels (view_geometry.h).
[[nodiscard]] DepthMesh triangulate(const DepthMap& depth, const Camera& camera,
                                    double disparity_px, const DepthMeshOptions& options = {});

}  // namespace lumi
