#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "calib/capture/rigid3.h"
#include "calib/work/config_section.h"

namespace lumi {

/// The way a photographer walks. All but the last two look at the target all along.
enum class PathKind {
    kArc,         ///< Part of a circle around the target, in one or more rows of height.
    kRing,        ///< Once around the target.
    kHemisphere,  ///< A spiral around the target, from the lowest to the highest elevation.
    kGrid,        ///< Rows and columns on a plane before the target.
    kLine,        ///< Sideways past the target.
    kForward,     ///< Towards the target.
    kRotation,    ///< The camera only turns: no depth can come of it.
};

[[nodiscard]] std::string_view name_of(PathKind kind);
[[nodiscard]] std::optional<PathKind> path_kind_named(std::string_view name);

/// Where photographs are taken from. The world's z axis points up; azimuth 0 stands on the -y side
/// of the target and grows towards +x.
struct HandHeldPath {
    PathKind kind = PathKind::kArc;
    int count = 24;    ///< Photographs. > 0.
    int rows = 1;      ///< Of arc and grid, walked to and fro; turns of the hemisphere. > 0.
    int start_at = 0;  ///< The walk begins at this place; those before it come last. [0, count).
    Eigen::Vector3d target_in_world = Eigen::Vector3d::Zero();
    double distance = 1.0;            ///< To the target, world units. > 0.
    double azimuth_deg = 0.0;         ///< Of the middle of the path.
    double span_deg = 60.0;           ///< Of arc and rotation, from end to end. >= 0.
    double elevation_deg = 15.0;      ///< Of the lowest row, above the horizon. (-90, 90).
    double top_elevation_deg = 15.0;  ///< Of the highest row of arc and hemisphere.
    double length_share = 0.6;        ///< Of grid, line and forward: length over distance. >= 0.
    /// How unsteady the hand is, standard deviations: position as a share of the distance, the
    /// rest in degrees. A camera that only turns keeps its place.
    double position_jitter_share = 0.0;
    double aim_jitter_deg = 0.0;
    double roll_jitter_deg = 0.0;
};

/// Throws Error (E-CONFIG-VALUE) with file, line and key.
[[nodiscard]] HandHeldPath read_hand_held_path(const ConfigSection& section);

/// `cam_from_world` of each photograph, in the order they are taken.
[[nodiscard]] std::vector<Rigid3> poses_along(const HandHeldPath& path, std::uint64_t seed);

/// A camera at `eye_in_world` that looks at `target_in_world`, upright.
[[nodiscard]] Rigid3 looking_at(const Eigen::Vector3d& eye_in_world,
                                const Eigen::Vector3d& target_in_world);

}  // namespace lumi
