#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/features/features.h"

namespace lumi {

/// How COLMAP 3.8 explains the matches of a pair (TwoViewGeometry::ConfigurationType).
enum class PairConfiguration : int {
    kUndefined = 0,
    kDegenerate = 1,
    kCalibrated = 2,
    kUncalibrated = 3,
    kPlanar = 4,
    kPanoramic = 5,
    kPlanarOrPanoramic = 6,
    kWatermark = 7,
    kMultiple = 8,
};

/// A pair of photographs whose matches agree with one motion of the camera.
struct VerifiedPair {
    int first = 0;  ///< Photographs by index, first < second.
    int second = 0;
    PairConfiguration configuration = PairConfiguration::kUndefined;
    std::vector<FeatureMatch> inliers;
};

/// A lens as COLMAP is told of it.
struct ColmapCamera {
    Camera camera;
    bool focal_length_is_known = false;  ///< From EXIF or a calibration, and not a guess.
};

/// A photograph as COLMAP is told of it. Its name in COLMAP is `colmap_image_name(index)`: the
/// photographs' own names, with their spaces and scripts, never reach COLMAP.
struct ColmapPhotograph {
    int camera_index = 0;
    std::vector<Eigen::Vector2f> keypoints_px;
};

[[nodiscard]] std::string colmap_image_name(int photograph_index);
/// Empty when the name is not one that `colmap_image_name` gives.
[[nodiscard]] std::optional<int> photograph_index_of(const std::string& colmap_image_name);

enum class KeypointsIn { kDatabase, kNothing };  ///< kNothing: COLMAP shall find its own.

/// Fills the empty database that COLMAP's `database_creator` made. Camera ids are index + 1, image
/// ids are index + 1. Throws Error (E-COLMAP-DATABASE).
void fill_colmap_database(const std::filesystem::path& database,
                          const std::vector<ColmapCamera>& cameras,
                          const std::vector<ColmapPhotograph>& photographs,
                          KeypointsIn keypoints = KeypointsIn::kDatabase);

/// Adds pairs that were verified elsewhere, as COLMAP's verification would have left them. Throws
/// Error (E-COLMAP-DATABASE).
void write_verified_pairs(const std::filesystem::path& database,
                          const std::vector<VerifiedPair>& pairs);

/// Replaces the keypoints of `photographs` by those in the database. Throws Error
/// (E-COLMAP-DATABASE) when a photograph has none, or other ones than COLMAP writes.
void read_keypoints(const std::filesystem::path& database,
                    std::vector<ColmapPhotograph>& photographs);

/// The pairs in which COLMAP found a geometry, ascending; those it found degenerate are left out.
/// Throws Error (E-COLMAP-DATABASE) when the file contradicts itself or `photographs`, or when
/// other than `expected_pairs` were judged: COLMAP's exit status does not tell.
[[nodiscard]] std::vector<VerifiedPair> read_verified_pairs(
    const std::filesystem::path& database, const std::vector<ColmapPhotograph>& photographs,
    std::size_t expected_pairs);

}  // namespace lumi
