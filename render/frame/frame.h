#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "render/transfer/focal_plane.h"

namespace lumi {

/// How a frame is drawn.
enum class RenderMode {
    kLightField,  ///< The paper without geometry: the scene is a plane through its centre.
    kPerPixel,    ///< Depth, weights and visibility at each pixel.
    kAdaptive,    ///< Triangles by an error in pixels, one pass.
    kPaper2001,   ///< The paper to the letter.
    kHeigl,       ///< Heigl et al. 1999: views triangulated anew for each frame.
};

/// What is shown instead of the picture.
enum class DebugPicture {
    kNone,
    kWeights,
    kFaces,
    kDepth,
    kConfidence,
    kOcclusion,  ///< The share of a ray's weight that views lose that do not see the point.
    kGrid,       ///< Over the picture, the edges of the triangles that it was put together from.
};

/// In the order in which they are offered.
[[nodiscard]] std::vector<RenderMode> all_render_modes();
[[nodiscard]] std::vector<DebugPicture> all_debug_pictures();
[[nodiscard]] std::string name_of(RenderMode mode);
[[nodiscard]] std::optional<RenderMode> render_mode_named(const std::string& name);
[[nodiscard]] std::string name_of(DebugPicture picture);
[[nodiscard]] std::optional<DebugPicture> debug_picture_named(const std::string& name);

struct RenderOptions {
    RenderMode mode = RenderMode::kPerPixel;
    DebugPicture debug_picture = DebugPicture::kNone;
    bool correct_occlusion = true;  ///< The paper's redistribution of weights.
    /// The plane that `lightfield` and `heigl` look photographs up on; where there is none, the
    /// scene plane, or depth, where `heigl` has some.
    FocalPlane focal_plane{};
    /// Four samples a pixel, for edges that are smooth: about four times the work. Frames
    /// (frame_target.h) take their mean; other framebuffers must be twice as wide and high, and
    /// hold the samples, in a viewport whose origin is even: those of a pixel know each other by
    /// their window coordinates.
    bool supersample = false;
    /// `perpixel`: where depth is sampled as finely as the frame, and each pixel is drawn by
    /// itself, silhouettes are the mean of four samples of depth (depth_eye.h): up to three
    /// times the work.
    bool smooth_silhouettes = true;
    /// Rays that leave the capture fade to black instead of being drawn from its border's cameras
    /// (see `capture_fade`). Not heeded by `paper2001` and `heigl`, which draw what their papers
    /// say.
    bool fade_beyond_capture = false;
    /// What no photograph shows gets the colours of what lies next to it (surroundings.h) instead
    /// of black; not where the capture fades to black, and not in `paper2001` and `heigl`.
    bool guess_surroundings = true;
    /// How finely the modes that subdivide do so, and the filling of holes in depth. Lengths are in
    /// pixels of the frame, also with four samples in each.
    double triangle_error_ratio = 1.0;    ///< `adaptive`: times DrawingChoices::triangle_error_px.
    double depth_threshold_share = 0.02;  ///< `paper2001`: of the scene's depth range.
    /// Shorter edges are not split; in `adaptive`, which cuts triangles at outlines, none that are
    /// shorter than twice this, and where it may err by more than kTriangleError_px, this grows
    /// with the root of the error.
    double min_triangle_px = 6.0;
    double max_triangle_px = 96.0;     ///< Longer edges are split in any case.
    std::size_t max_triangles = 5000;  ///< `adaptive`, and in holes: errors give way to it. 0: any.

    bool operator==(const RenderOptions&) const = default;
};

/// The number of samples along a side of each of the frame's pixels: the factor from lengths in
/// pixels of the frame to lengths in samples.
[[nodiscard]] inline double samples_along_pixel(const RenderOptions& options) {
    return options.supersample ? 2.0 : 1.0;
}

/// The wanted options, but `lightfield` in place of modes that need depth where there is none.
[[nodiscard]] RenderOptions possible_options(RenderOptions wanted, bool has_depth);

/// Whether these options ask for colours where no photograph shows anything.
[[nodiscard]] bool are_surroundings_drawn(const RenderOptions& options);

/// What drawing a frame took.
struct DrawStatistics {
    /// Triangles with photographs on them; each counts once, also where several passes draw it.
    std::size_t triangles = 0;
    /// Whether the triangles are those of the frame before, of the same eye: a moving eye's are
    /// made anew.
    bool are_triangles_kept = false;
};

/// What was drawn.
struct Frame {
    ColorImage color;
    /// 255 where the picture is known, 0 where it is not. There it is a guess: on the scene plane
    /// where nobody knows how far the scene is and photographs show nothing nearer (per pixel only
    /// if guesses are checked), or, per pixel, on what is stretched over a tear in depth where none
    /// of the ray's cameras sees it, or where only pixels show it that are mixed of two surfaces;
    /// where no photograph shows anything it is what surroundings.h says, or black.
    GrayImage coverage;
    DrawStatistics statistics{};
};

/// A frame that nothing is drawn into: black and uncovered.
[[nodiscard]] Frame empty_frame(const Camera& eye_camera);

}  // namespace lumi
