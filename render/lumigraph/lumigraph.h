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
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// Stands for no index of a view.
inline constexpr int kNoView = -1;

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
    /// The photograph's light times this is in the exposure of those around it.
    ExposureGain exposure_gain = kNoExposureGain;
    /// Made of `depth` with the package; null: made when it is first drawn
    /// (render/depth_mesh/view_depth_mesh.h). Whoever changes `depth` must reset it.
    std::shared_ptr<const DepthMesh> depth_mesh{};

    [[nodiscard]] bool has_depth() const { return !depth.inverse_depth.empty(); }
};

/// The free-form Lumigraph as it is drawn: what a package holds once it is in memory.
/// The camera mesh's view indices point into `views`.
struct Lumigraph {
    std::string name;
    std::vector<LumigraphView> views;
    CameraMesh mesh;
    double near_depth = 0.0;  ///< Scene depths seen by the views: 1st and 99th percentile, world
    double far_depth = 0.0;   ///< units.
    /// How closely depth meshes follow depth maps whose samples tell noise
    /// (DepthMeshOptions::max_noisy_error_px): the less, the more triangles.
    double noisy_depth_error_px = kNoisyDepthError_px;
    DrawingChoices drawing;
    /// How all photographs darken towards their corners (light_left.h); 0 where none tells it.
    double light_falloff = 0.0;
    /// That of the photographs as they were taken, once it was evened out (even_exposure.h).
    double evened_falloff = 0.0;

    /// Whether any view has.
    [[nodiscard]] bool has_depth() const;
    /// The least share of their light that photographs keep in their corners.
    [[nodiscard]] double light_left_in_corners() const;
};

/// Throws Error (E-LUMIGRAPH-INVALID, E-CAMERA-INVALID, E-MESH-INVALID) unless there is a view, the
/// names are unique, each camera is a pinhole of its photograph's size with numbers that some
/// camera has, poses and depths are finite, exposure gains, light falloff and what is chosen for
/// drawing within their limits and the mesh names views that exist; `where` begins the message.
void validate(const Lumigraph& lumigraph, const std::string& where);

/// What holds for the Lumigraph whichever views it has: neither views nor camera mesh.
[[nodiscard]] Lumigraph without_its_views(const Lumigraph& lumigraph);

/// The eye that a frame is drawn for. Pinhole, any size.
struct Eye {
    Camera camera;
    Rigid3 cam_from_world;
};

}  // namespace lumi
