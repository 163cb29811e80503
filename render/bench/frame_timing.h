#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What frames cost: wall and process CPU time of drawing and waiting until it is done.
struct FrameCost {
    double median_ms = 0.0;
    double p95_ms = 0.0;
    double cpu_ms = 0.0;  ///< Median over all threads of the process.
    double p95_cpu_ms = 0.0;
};

struct ModeCost {
    RenderOptions options;
    FrameCost cost;
    /// A frame by a graphics card's own clock (draw_queries.h): median over some frames of the
    /// path. Nothing where OpenGL works on the CPU, or cannot tell.
    std::optional<double> device_ms;
    double triangles = 0.0;  ///< Mean over the frames.
    /// In all passes, over the pixels of the picture: mean over some frames of the path. Nothing
    /// where the context cannot tell.
    std::optional<double> fragments_per_pixel;
    /// Of vertices, indices and texels that a frame hands to OpenGL: mean over the frames.
    double uploaded_bytes = 0.0;
    std::vector<double> frames_cpu_ms;  ///< Of each frame of the path.
    double ratio = 0.0;                 ///< Of the median wall times, to the three-texture blend.
    double cpu_ratio = 0.0;             ///< The same of CPU times.
};

struct FrameTimingReport {
    std::string gl_description;
    int width_px = 0;
    int height_px = 0;
    int frames = 0;
    int threads = 0;                       ///< That drawing and looking for depth share: all cores.
    std::size_t texture_bytes = 0;         ///< Of photographs and depth maps.
    FrameCost base;                        ///< The full-screen blend of three textures.
    std::optional<double> base_device_ms;  ///< As ModeCost::device_ms.
    std::vector<ModeCost> modes;
};

/// Frames that OpenGL is asked about, as asking is not to be timed: some, spread over the path.
[[nodiscard]] std::vector<Eye> frames_asked_about(const std::vector<Eye>& path);

/// Draws the path in every mode and the three-texture blend in turn (A B C, A B C ...), in one
/// context and one size, so that a machine whose speed drifts slows all of them alike. Two rounds
/// of warming up are not counted. Every frame costs what a moving eye's does, also where the path
/// rests (LumigraphRenderer::forget_frame). Throws Error (E-GL-...).
[[nodiscard]] FrameTimingReport time_frames(const Lumigraph& lumigraph,
                                            const std::vector<Eye>& path,
                                            const std::vector<RenderOptions>& modes,
                                            Progress& progress);

}  // namespace lumi
