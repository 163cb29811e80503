#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/colmap/colmap_database.h"
#include "calib/ingest/ingest.h"

namespace lumi {

/// What is taken for granted of the lenses.
struct LensGrouping {
    std::string lens_model = "auto";  ///< Of those that are not given.
    bool shared_lens = true;          ///< One lens for photographs of one camera and zoom.
};

/// Which photographs share a lens, and what is known of each lens beforehand.
struct CameraGroups {
    std::vector<ColmapCamera> cameras;
    std::vector<int> camera_of_photograph;  ///< Index into `cameras`, one per photograph.
};

/// Groups by Photograph::camera_key and size, in the order of first appearance; without
/// `shared_lens` each photograph is a group of its own.
///
/// A given lens is rescaled to each group's size and refused (E-POSES-LENS) when the photographs
/// have another shape. Otherwise the focal length is EXIF's (the median of the group); unknown,
/// that of other photographs of exactly this size, whose camera it most likely was; or, unknown
/// there too, 1.2 times the longer side, as COLMAP guesses; the latter from the median size of all
/// photographs whose size is within 10 % of it, because crops of one camera's pictures keep its
/// focal length.
[[nodiscard]] CameraGroups group_cameras(const std::vector<Photograph>& photographs,
                                         const std::optional<Camera>& given_lens,
                                         const LensGrouping& options);

/// Whether something tells the focal length of every photograph, if only roughly (EXIF).
[[nodiscard]] bool focal_lengths_are_known(const CameraGroups& groups);

}  // namespace lumi
