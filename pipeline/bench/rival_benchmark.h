#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"

namespace lumi {

struct RivalBenchmarkOptions {
    int size_px = 256;        ///< Of photographs and frames, as in the paper.
    int frames = 24;          ///< Timed for each method.
    int held_out = 8;         ///< Photographs that take no part, to measure against.
    int flicker_frames = 24;  ///< Of a path from one held-out place to the next. 0: none.
};

/// One way of drawing one of the scenes.
struct RivalFigures {
    std::string method;
    std::string settings;
    int pictures = 0;  ///< That are drawn from: photographs, or those they were resampled to.
    double triangles = 0.0;
    std::optional<double> cpu_ms;   ///< Median CPU time of a frame.
    std::optional<double> wall_ms;  ///< The same by the clock: what frames a second are counted by.
    /// To a full-screen blend of three textures; empty for plain code, on one core.
    std::optional<double> cpu_ratio;
    double psnr_db = 0.0;          ///< Mean over held-out photographs, all pixels.
    double psnr_covered_db = 0.0;  ///< Over what the method covers.
    double coverage = 0.0;
    /// Share of pixels that show another surface: off by more than a fifth of the range, and not
    /// within two pixels of a silhouette.
    double wrong_layer_share = 0.0;
    /// Of these, where some photograph shows the surface that is there (shown_pixels.h): what a
    /// method gets wrong, not what nobody can know.
    double avoidable_wrong_layer_share = 0.0;
    /// Mean absolute difference between the change from frame to frame and the true change, in
    /// steps of 1/255.
    std::optional<double> flicker;
};

/// A scene after one of the paper's figures 7 to 9.
struct RivalScene {
    std::string name;
    int photographs = 0;
    std::string paper;  ///< What the paper reports of its scene.
    std::vector<RivalFigures> rivals;
    double resampling_cpu_s = 0.0;  ///< To two planes.
    /// Of the frame's time that occlusion correction takes: adaptive, and per pixel.
    double adaptive_occlusion_share = 0.0;
    double per_pixel_occlusion_share = 0.0;
};

/// The paper's experiments on synthetic scenes like its own, lumi's modes beside the methods that
/// the paper names. Photographs, poses and depth are exact, so that what is compared is drawing
/// alone. `scenes` are names (rival_scenes.h).
[[nodiscard]] std::vector<RivalScene> benchmark_rivals(const RivalBenchmarkOptions& options,
                                                       const std::vector<std::string>& scenes,
                                                       Progress& progress);

}  // namespace lumi
