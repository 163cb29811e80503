#pragma once

#include <optional>
#include <vector>

#include "meshing/cameras/camera_directions.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Cameras that stand in a row: on a line, an arc or a ring about the scene.
struct CameraRow {
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  ///< Of the plane of the row.
    std::vector<std::size_t> order;                     ///< Cameras by azimuth about the normal.
    std::vector<double> azimuths_rad;                   ///< Increasing, in the same order.
    bool ring = false;                                  ///< The row closes around the scene.
};

/// The row, when the cameras' heights above its plane are smaller than half their spacing along it:
/// then which of two neighbours is higher is chance, and a triangulation would be made of slivers.
/// Whatever their heights when `forced`.
[[nodiscard]] std::optional<CameraRow> find_row(const std::vector<CameraDirection>& cameras,
                                                bool forced);

/// Each camera stands twice, far above and far below the row's plane, and neighbours are joined by
/// two triangles: the limit in which weights change along the row only. An open row is continued
/// past both ends by their last cameras.
[[nodiscard]] CameraMesh strip_of_row(const CameraRow& row,
                                      const std::vector<CameraDirection>& cameras,
                                      const Eigen::Vector3d& scene_centre_in_world);

}  // namespace lumi
