#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "meshing/surface/camera_mesh.h"
#include "meshing/surface/depth_map.h"
#include "render/lumigraph/depth_mesh.h"

namespace lumi {

/// Factors of red, green and blue light; those of a photograph that needs no evening.
using ExposureGain = std::array<double, 3>;
inline constexpr ExposureGain kNoExposureGain{1.0, 1.0, 1.0};
inline constexpr double kLargestExposureGain = 16.0;  ///< And its inverse the least.

/// One photograph of the Lumigraph: an undistorted picture, where it was taken, and its depth.
struct LumigraphView {
    std::string name;
    Camera camera;  ///< LensModel::kPinhole, the size of `photograph`.
    Rigid3 cam_from_world;
    int exif_orientation = 1;  ///< For display only; 1 to 8.
    ColorImage photograph;
    DepthMap depth;  ///< Empty images when the package has no depth.
    /// Times this the photograph's light is in the exposure of those around it.
    ExposureGain exposure_gain = kNoExposureGain;
    /// Made of `depth` when the package was; null where it is made when it is drawn
    /// (render/depth_mesh/view_depth_mesh.h). Who changes `depth` resets it.
    std::shared_ptr<const DepthMesh> depth_mesh{};
};

/// Two views whose depths agree outvote a third; with four, one may also not know.
inline constexpr int kLeastDepthViews = 3;
inline constexpr int kMaxDepthViews = 4;

/// Depth may be worked out for blocks of so many by so many pixels: a GL draws four pixels at once,
/// and no more.
inline constexpr int kDepthBlockSide_px = 2;
/// How wide such blocks may be, in pixels of the photographs. The narrowest: nobody can tell.
inline constexpr double kLeastDepthBlock_px = 1.0;
inline constexpr double kMaxDepthBlock_px = kDepthBlockSide_px;

/// Disparity by which depths of one surface may differ.
inline constexpr double kAgreeingDisparity_px = 1.5;

/// Of a view that sees something else than a point: what is asked for where photographs were not
/// asked, and what may be.
inline constexpr double kOcclusionTolerance_px = kAgreeingDisparity_px;
inline constexpr double kLeastOcclusionTolerance_px = 0.1;
inline constexpr double kMostOcclusionTolerance_px = 100.0;

/// Of the triangles that `adaptive` draws: what is asked for where photographs were not asked, and
/// what may be.
inline constexpr double kTriangleError_px = 0.7;
inline constexpr double kLeastTriangleError_px = 0.1;
inline constexpr double kMostTriangleError_px = 10.0;

/// The free-form Lumigraph as it is drawn: what a package holds once it is in memory.
/// The camera mesh's view indices point into `views`.
struct Lumigraph {
    std::string name;
    std::vector<LumigraphView> views;
    CameraMesh mesh;
    double near_depth = 0.0;  ///< Scene depths seen by the views: 1st and 99th percentile, world
    double far_depth = 0.0;   ///< units.
    /// How it wants to be drawn where nobody says otherwise (RenderOptions::fade_beyond_capture).
    bool fade_beyond_capture = false;
    /// Disparity beyond which a view sees something else than the point that is drawn
    /// (occlusion.h): the more, the less its depth is to be trusted.
    double occlusion_tolerance_px = kOcclusionTolerance_px;
    /// How closely depth meshes follow depth maps whose samples tell noise
    /// (DepthMeshOptions::max_noisy_error_px): the less, the more triangles.
    double noisy_depth_error_px = kNoisyDepthError_px;
    /// How many views' depths are compared at each pixel, or as many views as there are.
    int depth_views = kMaxDepthViews;
    /// Per pixel, depth is worked out for blocks of pixels in frames so fine that these are no
    /// wider than that, in pixels of the photographs; for kMaxDepthBlock_px in any frame.
    double depth_block_px = kLeastDepthBlock_px;
    /// Whether, per pixel, what none of these views sees is drawn from others
    /// (render/holes/hole_triangles.h): worth its time where much is hidden from them.
    bool fills_holes = false;
    /// Whether, per pixel, what is drawn on the scene plane where no depth is known is only what no
    /// view's depth has something before (kSurelyBefore_px), seen or filled: worth its time where
    /// subjects stand alone.
    bool checks_guesses = false;
    /// How far from the right place `adaptive` may look up photographs before it splits triangles.
    double triangle_error_px = kTriangleError_px;
    /// Whether it draws what is thinner than its triangles over them (thin_triangles.h): worth its
    /// time where there are bars, cables or leaves.
    bool draws_thin = false;
};

/// Throws Error (E-LUMIGRAPH-INVALID, E-CAMERA-INVALID, E-MESH-INVALID) unless there is a view, the
/// names are unique, each camera is a pinhole of its photograph's size, poses and depths are
/// finite, exposure gains, depth views, blocks and the errors of triangles within their limits and
/// the mesh names views that exist; `where` begins the message.
void validate(const Lumigraph& lumigraph, const std::string& where);

/// What holds for the Lumigraph whichever views it has: neither views nor camera mesh.
[[nodiscard]] Lumigraph without_its_views(const Lumigraph& lumigraph);

/// The eye that a frame is drawn for. Pinhole, any size.
struct Eye {
    Camera camera;
    Rigid3 cam_from_world;
};

}  // namespace lumi
