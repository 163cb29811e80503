#pragma once

#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/bench/rival_figures.h"
#include "pipeline/bench/rival_measurement.h"

namespace lumi {

struct RivalBenchmarkOptions {
    int size_px = 256;        ///< Of photographs and frames, as in the paper.
    int frames = 24;          ///< Timed for each method.
    int held_out = 8;         ///< Photographs that take no part, to measure against.
    int flicker_frames = 24;  ///< Of a path from one held-out place to the next. 0: none.
};

/// A scene after one of the paper's figures 7 to 9.
struct RivalScene {
    std::string name;
    int photographs = 0;
    std::string paper;  ///< What the paper reports of its scene.
    std::vector<RivalFigures> rivals;
    double common_share = 0.0;              ///< Of pixels that all methods that have a say cover.
    double off_cameras_common_share = 0.0;  ///< The same of eyes off the cameras.
    /// Of the frame's time that occlusion correction takes: adaptive, and per pixel.
    double adaptive_occlusion_share = 0.0;
    double per_pixel_occlusion_share = 0.0;
};

/// The paper's experiments on synthetic scenes like its own, lumi's modes beside the methods that
/// the paper names. Photographs, poses and depth are exact, so that what is compared is drawing
/// alone. `scenes` are names (rival_scenes.h). `keep` is called with every frame of a held-out
/// place (RivalMeasurement).
[[nodiscard]] std::vector<RivalScene> benchmark_rivals(const RivalBenchmarkOptions& options,
                                                       const std::vector<std::string>& scenes,
                                                       const RivalPictureSink& keep,
                                                       Progress& progress);

}  // namespace lumi
