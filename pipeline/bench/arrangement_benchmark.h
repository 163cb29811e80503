#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/bench/mesh_benchmark.h"

namespace lumi {

/// What the camera mesh comes to for one arrangement of so many cameras.
struct ArrangementFigures {
    std::string name;
    int cameras = 0;
    std::string construction;
    int cameras_kept = 0;
    int shells = 0;
    long rays = 0;           ///< From the cameras' side, to what lies in the kernel.
    long rays_answered = 0;  ///< Those that some face gives weights.
    long rays_with_one_face = 0;
    int most_cameras_a_ray = 0;
    double worst_sum_error = 0.0;      ///< |sum of weights - 1|.
    double worst_inconsistency = 0.0;  ///< Half the difference between two eyes on one ray.
    double largest_jump = 0.0;         ///< Along paths, at one place.
    double worst_unslid_epipole_loss = 0.0;
    double cpu_s = 0.0;  ///< Of making the mesh.
};

/// How long the mesh of one arrangement takes against its number of cameras.
struct ArrangementGrowth {
    std::string name;
    std::vector<MeshTiming> timings;
    double growth_exponent = 0.0;
};

/// Every arrangement (synthetic_captures.h) with 1, 10, 100 and 1000 cameras.
[[nodiscard]] std::vector<ArrangementFigures> benchmark_arrangements(std::uint64_t seed,
                                                                     Progress& progress);

/// Every arrangement with 1000 cameras, and ten times as many as long as there are at most
/// `most_cameras`. Those that do not grow with the number are left out.
[[nodiscard]] std::vector<ArrangementGrowth> time_arrangements(int most_cameras, std::uint64_t seed,
                                                               Progress& progress);

/// A picture of the mesh of each arrangement of 40 cameras, as SVG files named after them.
void draw_arrangements(const std::filesystem::path& folder, std::uint64_t seed);

}  // namespace lumi
