#pragma once

#include <optional>
#include <string>
#include <vector>

namespace lumi {

/// One frame of a method beside the photograph that was held out.
struct RivalFrameFigures {
    double psnr_db = 0.0;                   ///< All pixels (RivalFigures::psnr_db).
    double psnr_as_drawn_db = 0.0;          ///< All pixels (RivalFigures::psnr_as_drawn_db).
    std::optional<double> psnr_covered_db;  ///< Over what the method covers; empty: nothing.
    std::optional<double> psnr_common_db;   ///< RivalFigures::psnr_common_db.
    double coverage = 0.0;
};

/// Of frames of eyes off the cameras (RivalCapture::off_cameras), beside what is true.
struct OffCamerasFigures {
    std::optional<double> psnr_common_db;   ///< As RivalFigures::psnr_common_db.
    std::optional<double> psnr_covered_db;  ///< As RivalFigures::psnr_covered_db.
    double coverage = 0.0;
};

/// One way of drawing one of the scenes.
struct RivalFigures {
    std::string method;
    std::string settings;
    int pictures = 0;  ///< Drawn from: photographs, or the pictures they were resampled to.
    double triangles = 0.0;
    std::optional<double> cpu_ms;   ///< Median CPU time of a frame.
    std::optional<double> wall_ms;  ///< The same by the clock: what frames a second are counted by.
    /// The part of the CPU time that finding depth at the eye takes, which papers take for given;
    /// only of methods in plain code that draw with it.
    std::optional<double> depth_cpu_ms;
    /// CPU time over that of a full-screen blend of three textures, on one core; empty for plain
    /// code.
    std::optional<double> cpu_ratio;
    /// CPU time of resampling, before the first frame; empty where photographs are drawn from.
    std::optional<double> resampling_cpu_s;
    /// Mean over held-out photographs, all pixels. What a method does not cover has the colours of
    /// its surroundings (surroundings.h), the same for all methods.
    double psnr_db = 0.0;
    /// The same of frames as they are drawn: lumi's modes, and what they draw of resampled
    /// pictures, guess what is not covered, by depth that is stretched and by surroundings;
    /// `paper2001`, `heigl` and methods in plain code leave it black.
    double psnr_as_drawn_db = 0.0;
    /// Mean over the frames in which the method covers any pixel, of the pixels that it covers;
    /// `covered_frames` counts these frames.
    std::optional<double> psnr_covered_db;
    int covered_frames = 0;
    /// Over what all methods that have a say cover (common_pixels.h): the same pixels for all.
    std::optional<double> psnr_common_db;
    double coverage = 0.0;
    OffCamerasFigures off_cameras;
    /// Of the pixels that the method covers in any frame, the share that shows another surface: off
    /// by more than a fifth of the range, and not within two pixels of a silhouette. Empty where
    /// nothing is covered.
    std::optional<double> wrong_layer_share;
    /// Of these, where some photograph shows the surface that is there (shown_pixels.h): what a
    /// method gets wrong, not what nobody can know.
    std::optional<double> avoidable_wrong_layer_share;
    /// Mean absolute difference between the change from frame to frame and the true change, in
    /// steps of 1/255, over all pixels as in psnr_db.
    std::optional<double> flicker;
    std::vector<RivalFrameFigures> frames;  ///< Of each held-out photograph.
};

}  // namespace lumi
