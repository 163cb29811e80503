#pragma once

#include <Eigen/Core>
#include <functional>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/transfer/focal_plane.h"

namespace lumi {

/// Draws a frame of the Lumigraph that is resampled.
using DrawEye = std::function<Frame(const Eye&)>;

/// Where the pictures of a parameterised light field are taken from, and its camera mesh.
struct LightFieldLayout {
    std::vector<Eye> eyes;
    CameraMesh mesh;  ///< Its view indices point into `eyes`.
    /// Of which all pictures show the same rectangle: without depth they are looked up there. None
    /// where they share none.
    FocalPlane shared_plane{};
};

/// Half the width and half the height that the median photograph shows at the scene's centre: what
/// the pictures of a parameterised light field show.
[[nodiscard]] Eigen::Vector2d seen_half_size(const Lumigraph& source);

/// The frame of a picture whose z axis is `z` (unit), with `down` as its y axis as far as that
/// goes: its rows are the axes in the world.
[[nodiscard]] Eigen::Matrix3d rotation_with_axis(const Eigen::Vector3d& z,
                                                 const Eigen::Vector3d& down);

/// The Lumigraph whose pictures a regular parameterisation asks for, drawn from another one
/// ("rebinned"): what capture by hand costs such parameterisations, in time and in sharpness. Depth
/// is resampled, too, where the source has any.
[[nodiscard]] Lumigraph resampled(const Lumigraph& source, LightFieldLayout layout,
                                  const DrawEye& draw);

}  // namespace lumi
