#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/bench/weights_measurement.h"

namespace lumi {

struct MeshBenchmarkOptions {
    int captures = 200;
    int rays = 1'000'000;      ///< Over all captures.
    double roughness = 0.25;   ///< Distances vary by this share, each camera on its own.
    double scene_share = 0.5;  ///< The scene's radius over the mean camera distance.
    int most_cameras_timed = 100'000;
    std::uint64_t seed = 1;
};

struct MeshTiming {
    int cameras = 0;
    double cpu_s = 0.0;
};

/// p of cpu_s ~ cameras^p, by least squares in logarithms from 1000 cameras on; 0 for fewer than
/// two timings.
[[nodiscard]] double growth_exponent(const std::vector<MeshTiming>& timings);

/// What the kernel-star mesh is worth over random captures all around a scene.
struct MeshBenchmark {
    int captures = 0;
    long cameras = 0;
    long cameras_kept = 0;
    long rays = 0;
    long rays_with_one_face = 0;
    double least_kernel_over_scene = 0.0;
    int captures_repaired_by_flips = 0;  ///< Alone.
    int captures_repaired_by_slides = 0;
    int captures_not_repaired = 0;
    long cameras_slid = 0;
    double rms_slide_share = 0.0;
    double largest_slide_share = 0.0;
    double worst_epipole_loss = 0.0;  ///< Of cameras that were slid.
    double rms_epipole_loss = 0.0;    ///< Over all cameras, each with its worst ray.
    double worst_epipole_loss_over_bound = 0.0;
    double worst_unslid_epipole_loss = 0.0;  ///< Of the others.
    long convex_cameras_kept = 0;            ///< By the paper's convex mesh.
    double convex_rms_push_share = 0.0;
    double convex_largest_push_share = 0.0;
    /// Of the mesh, Heigl et al., unstructured lumigraph, view-dependent texture.
    std::vector<WeightsFigures> weights;
    std::vector<MeshTiming> timings;
    double growth_exponent = 0.0;
};

[[nodiscard]] MeshBenchmark benchmark_mesh(const MeshBenchmarkOptions& options, Progress& progress);

}  // namespace lumi
