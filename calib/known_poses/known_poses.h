#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/known_poses/stated_lens.h"

namespace lumi {

/// A lens as a file of poses states it.
struct KnownLens {
    Camera camera;
    /// Stands instead of `camera` where the file states no size: for any that photographs have.
    std::optional<StatedLens> of_any_size;

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
/// a Strecha `.camera` file or a folder of them; a folder that holds exactly one of the other
/// single files will do too. A folder's format is told by the names of its files, that of a file by
/// how it begins, or by `.camera`. Throws Error: E-IMPORT-FORMAT, or that of the format.
[[nodiscard]] KnownPoses read_known_poses(const std::filesystem::path& path);

/// Adds the lens unless it stands there already; its index.
int index_of_lens(std::vector<KnownLens>& lenses, const KnownLens& lens);

}  // namespace lumi
