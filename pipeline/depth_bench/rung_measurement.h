#pragma once

#include <optional>
#include <string>
#include <vector>

#include "meshing/depth/depth_stage.h"
#include "meshing/surface/camera_mesh.h"
#include "pipeline/evaluate/evaluation.h"

namespace lumi {

/// Photographs with poses on which the rungs of the ladder of depth models are measured.
struct DepthBenchScene {
    std::string name;
    PosedPhotographs used;
    PosedPhotographs held_out;  ///< Take no part in depth.
    CameraMesh mesh;            ///< Over the views of `used`.
    /// Exact depth (float TIFF, imported_depth.h) of the straight pictures of the used views, a
    /// file of each; empty when it is not known.
    std::vector<std::filesystem::path> truth_files = {};
    std::filesystem::path truth_folder = {};  ///< What it was made from, for messages.
};

/// Accuracy and cost of one rung on one scene.
struct RungMeasurement {
    std::string scene;
    std::string model;
    std::string choice;                ///< Of "auto": what was chosen and why; else empty.
    double cpu_s_per_megapixel = 0.0;  ///< Of depth map, choice included, photographs once read.
    double expected_peak_mib = 0.0;    ///< Of the process while depth is found, as predicted.
    /// And as measured (VmHWM of proc(5)); empty where the system does not tell.
    std::optional<double> peak_mib;
    ViewScore held_out;  ///< Mean over the held-out views.
    /// Root of the mean squared error over covered pixels, 8-bit levels, and its standard error
    /// over tiles of 64 pixels.
    double rms_error = 0.0;
    double rms_standard_error = 0.0;
    double sparse_residual_px = 0.0;  ///< Median over the views.
    double confident_share = 0.0;     ///< Mean over the views.
    /// Share of confident pixels within one pixel of the true disparity; empty without truth.
    std::optional<double> right_share;
    /// The same of the pixels with texture that some neighbour sees, whether confident or filled.
    std::optional<double> right_visible_share;
};

/// Estimates depth with `options`, packs and draws the held-out views. `keep` gets what was drawn.
[[nodiscard]] RungMeasurement measure_rung(const DepthBenchScene& scene,
                                           const DepthOptions& options, int threads,
                                           const JudgedViewSink& keep, Progress& progress);

}  // namespace lumi
