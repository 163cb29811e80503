#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "meshing/cameras/camera_mesh_builder.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// A way in which a Lumigraph can be wrong.
struct Perturbation {
    std::string name;               ///< "pose_rotation_deg": also the key under [stress].
    std::string words;              ///< "rotation of the poses (degrees)".
    std::vector<double> strengths;  ///< Rising, above 0: from harmless to hopeless.
    /// The Lumigraph with the error of that strength. The same for the same seed; errors of
    /// different strengths are the same error scaled. `mesh_options`: of its camera mesh, where
    /// another has to be built.
    Lumigraph (*apply)(const Lumigraph& lumigraph, double strength, std::uint64_t seed,
                       const CameraMeshOptions& mesh_options) = nullptr;
};

/// All of them: rotation and position of the poses, focal length, depth, exposure, sharpness, views
/// dropped.
[[nodiscard]] const std::vector<Perturbation>& known_perturbations();

/// The words of the one of that name; the name, where none has it.
[[nodiscard]] std::string words_of_perturbation(const std::string& perturbation);

/// Every view turned by a rotation about a random axis, its angle normal with `sigma_deg`.
[[nodiscard]] Lumigraph with_turned_poses(const Lumigraph& lumigraph, double sigma_deg,
                                          std::uint64_t seed);
/// Every camera moved; `share` is the standard deviation along each axis in percent of the median
/// distance to the nearest other camera.
[[nodiscard]] Lumigraph with_moved_poses(const Lumigraph& lumigraph, double share_percent,
                                         std::uint64_t seed);
/// Focal lengths longer by `percent`.
[[nodiscard]] Lumigraph with_longer_focal_length(const Lumigraph& lumigraph, double percent,
                                                 std::uint64_t seed);
/// Inverse depths times 1 + noise of standard deviation `percent`, smooth over a 32nd of the width.
[[nodiscard]] Lumigraph with_noisy_depth(const Lumigraph& lumigraph, double percent,
                                         std::uint64_t seed);
/// Photographs exposed longer or shorter, normal with `sigma_ev` stops, in linear light.
[[nodiscard]] Lumigraph with_other_exposure(const Lumigraph& lumigraph, double sigma_ev,
                                            std::uint64_t seed);
/// Photographs blurred by a Gaussian.
[[nodiscard]] Lumigraph with_blurred_photographs(const Lumigraph& lumigraph, double sigma_px,
                                                 std::uint64_t seed);
/// `percent` of the views left out, and a camera mesh over the others; a greater share leaves out
/// the same views and more. At least one view stays.
[[nodiscard]] Lumigraph with_views_dropped(const Lumigraph& lumigraph, double percent,
                                           std::uint64_t seed,
                                           const CameraMeshOptions& mesh_options);

}  // namespace lumi
