#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "meshing/cameras/camera_star.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// How the cameras stand around the scene centre, and with it which construction fits.
struct Arrangement {
    MeshConstruction construction = MeshConstruction::kSingle;
    /// The cameras look away from the centre, as in a room photographed from its middle.
    bool inside_out = false;
    /// For kLine and kPair: what the strip is stretched along, of length one.
    Eigen::Vector3d strip_normal = Eigen::Vector3d::UnitY();
    /// For kOpen: where no camera stands, as a direction from the centre, of length one.
    Eigen::Vector3d gap_direction = Eigen::Vector3d::UnitZ();
    std::string reason;  ///< Why, with the figures that decided; the end of a sentence.
};

/// Decides by the singular values of the directions, by the largest cap of directions without a
/// camera, and by how many triangles are thin.
[[nodiscard]] Arrangement arrange(const CameraStar& star);

/// The arrangement of cameras that stand behind each other (forward_motion.h), if they do: what no
/// star can hold.
[[nodiscard]] std::optional<Arrangement> arrange_forward(const std::vector<OpticalAxis>& axes);

/// The arrangement for a construction that the user demands: closed, open, line or nearest. Throws
/// Error (E-MESH-CONSTRUCTION) when the cameras cannot carry it.
[[nodiscard]] Arrangement arrange_as(const CameraStar& star, MeshConstruction construction);

}  // namespace lumi
