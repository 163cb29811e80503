#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// A lens as a file of poses states it.
struct KnownLens {
    Camera camera;               ///< Its size is 0x0 when `size_is_stated` is false.
    bool size_is_stated = true;  ///< False: the lens is for photographs of the size they have.
    /// Stands instead of the camera's parameters when the file tells neither size nor pixels.
    std::optional<double> angle_of_view_x_rad;

    friend bool operator==(const KnownLens&, const KnownLens&) = default;
};

/// Poses as another program wrote them: COLMAP axes and pixels, names and sizes as in the file.
struct KnownPoses {
    std::string format;  ///< In words, such as "COLMAP model".
    std::vector<KnownLens> lenses;
    std::vector<View> views;         ///< `camera_index` is into `lenses`.
    bool has_names = true;           ///< False: the views are the photographs sorted by name.
    std::vector<ScenePoint> points;  ///< Tracks are into `views`.
};

/// Reads a COLMAP model folder, `transforms.json`, `poses_bounds.npy`, a Middlebury `*_par.txt` or
/// a folder of Strecha `.camera` files; a folder that holds exactly one of the single files will do
/// too. The format is told by content. Throws Error: E-IMPORT-FORMAT, or that of the format.
[[nodiscard]] KnownPoses read_known_poses(const std::filesystem::path& path);

/// Adds the lens unless it stands there already; its index.
int index_of_lens(std::vector<KnownLens>& lenses, const KnownLens& lens);

}  // namespace lumi
