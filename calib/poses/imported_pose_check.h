#pragma once

#include <filesystem>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/colmap/colmap_database.h"
#include "calib/ingest/ingest.h"
#include "calib/work/progress.h"

namespace lumi {

/// What photographs say of poses that they did not give.
struct PoseCheck {
    int pairs_asked = 0;   ///< Of photographs that ought to show the same things.
    int pairs = 0;         ///< That show the same things, by an epipolar geometry.
    int pairs_denied = 0;  ///< Of these: for half of their matches the poses are far off.
    int pairs_turned = 0;  ///< Of these: the poses fit better to pictures that are turned.
    /// By how much half of all matches are off, in pixels of the working copies.
    double median_error_px = 0.0;
};

/// How far a match is from what two poses allow, in pixels of the second camera: from the picture
/// of what the first sees at the one pixel, from there on to infinitely far away, which must pass
/// the other. Beside epipolar geometry it tells a scene before the cameras from one behind them.
[[nodiscard]] double distance_from_ray_px(const Camera& first, const Rigid3& first_from_world,
                                          const Eigen::Vector2d& pixel_in_first,
                                          const Camera& second, const Rigid3& second_from_world,
                                          const Eigen::Vector2d& pixel_in_second);

/// The matches of pairs against the poses of their views. Pairs are into `photographs`, which are
/// those of the capture's views; all of them count as asked.
[[nodiscard]] PoseCheck check_poses(const Capture& capture,
                                    const std::vector<ColmapPhotograph>& photographs,
                                    const std::vector<VerifiedPair>& pairs);

/// The same of eight views, spread over the capture, and their neighbours by the poses, which are
/// asked. Their working copies are matched for it, in what masks leave of them
/// (PoseOptions::mask_folder); where fewer than half of these show the same things, of photographs
/// that do so by their look, if they deny the poses or the poses make none neighbours.
[[nodiscard]] PoseCheck check_imported_poses(const Capture& capture,
                                             const std::vector<Photograph>& photographs,
                                             const std::filesystem::path& mask_folder, int threads,
                                             Progress& progress);

/// A sentence where some pairs deny the poses, or fewer than half tell; else empty.
/// Throws Error where more than half of at least three pairs or of all that were asked do, or,
/// where none were asked, all of at least three: E-IMPORT-TURNED where turned pictures would do
/// (what is turned by half a turn seems to be itself, inside out), else E-IMPORT-DENIED.
[[nodiscard]] std::string warning_of(const PoseCheck& check);

}  // namespace lumi
