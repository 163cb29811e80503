#pragma once

#include <Eigen/Core>

#include "render/lumigraph/lumigraph.h"
#include "render/viewer/scene_bounds.h"

namespace lumi {

/// Where the eye is and what it moves about. The controls are functions from one to the next.
struct Navigation {
    Eye eye;
    Eigen::Vector3d pivot_in_world = Eigen::Vector3d::Zero();
    Eigen::Vector3d up_in_world = -Eigen::Vector3d::UnitY();  ///< Of length one.
    /// Where the pivot is nearer, the wheel pushes it on, and the eye flies as if it were as far.
    double least_distance = 0.0;
};

/// A third of the distance at which the scene begins before the cameras.
[[nodiscard]] double least_distance(const Lumigraph& lumigraph);

/// Turns about the pivot, which keeps its pixel: the scene follows the cursor, half a turn for the
/// height of the picture; sideways about `up_in_world`, up and down about the eye's x axis. Stops
/// before it would look along `up_in_world`.
[[nodiscard]] Navigation orbit(const Navigation& from, const Eigen::Vector2d& drag_px);

/// Turns the eye on the spot; the scene follows the cursor.
[[nodiscard]] Navigation look(const Navigation& from, const Eigen::Vector2d& drag_px);

/// Moves parallel to the image plane, so that what is as far away as the pivot follows the cursor.
/// The pivot moves along with the eye.
[[nodiscard]] Navigation pan(const Navigation& from, const Eigen::Vector2d& drag_px);

/// Moves towards the pivot (steps > 0) or away: a tenth of the distance a step. The pivot keeps its
/// pixel. Once it is as near as `least_distance`, each further step is a tenth of that, and the
/// pivot moves along.
[[nodiscard]] Navigation zoom(const Navigation& from, double steps);

/// Moves along the eye's own axes (x right, y down, z forward), in units of the distance to the
/// pivot, or of `least_distance` where that is more; the pivot moves along.
[[nodiscard]] Navigation fly(const Navigation& from, const Eigen::Vector3d& move_in_cam);

/// Stands where another eye does and turns about what is straight ahead of it, as far away as the
/// pivot was.
[[nodiscard]] Navigation carried_to(const Navigation& from, const Eye& eye);

/// Stands where a photograph was taken and turns about what its middle shows. Throws
/// std::out_of_range for a view that does not exist.
[[nodiscard]] Navigation snap_to(const Navigation& from, const Lumigraph& lumigraph,
                                 int view_index);

/// The same eye, that turns about what the drawing shows of the scene at a place of its picture, as
/// the views' depths know it; where nobody knows a depth there, or it is infinite, as before.
[[nodiscard]] Navigation turning_about(const Navigation& from, const Lumigraph& lumigraph,
                                       const Eigen::Vector2d& place_px);

/// Backs away, or comes closer, without turning until the ball just fits into the picture; turns
/// about its centre from then on.
[[nodiscard]] Navigation frame_all(const Navigation& from, const SceneBounds& bounds);

/// The view whose photograph was taken nearest to the eye.
[[nodiscard]] int nearest_view(const Lumigraph& lumigraph, const Eye& eye);

}  // namespace lumi
