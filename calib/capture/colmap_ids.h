#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// An image record of a COLMAP model with the file's own ids.
struct ColmapImageRecord {
    std::uint32_t camera_id = 0;
    View view;
    std::vector<Eigen::Vector2d> keypoints_px;
};

/// A point record: its track names images by id and keypoints by index.
struct ColmapPointRecord {
    ScenePoint point;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> track;
};

/// A COLMAP model as its three files tell it, keyed by the file's ids.
struct ColmapRecords {
    std::map<std::uint32_t, Camera> cameras;
    std::map<std::uint32_t, ColmapImageRecord> images;
    std::map<std::uint64_t, ColmapPointRecord> points;
};

/// Resolves ids into indices, sorts the views by name, and checks that every id exists. Throws
/// Error (E-COLMAP-MODEL); `where` begins the message.
[[nodiscard]] Capture capture_from_records(const ColmapRecords& records, const std::string& where);

/// For each view the observed pixels in the order in which they are written, and for each point the
/// index of each of its observations in its view's list.
struct ColmapKeypoints {
    std::vector<std::vector<std::pair<Eigen::Vector2d, std::size_t>>> by_view;  ///< Pixel, point.
    std::vector<std::vector<std::size_t>> index_in_view;
};
[[nodiscard]] ColmapKeypoints keypoints_of(const Capture& capture);

/// COLMAP rounds its quaternions in text; a norm within 1 % is made exactly one, any other is left
/// for validation to refuse.
[[nodiscard]] Eigen::Quaterniond checked_unit(const Eigen::Quaterniond& rotation);

[[noreturn]] void refuse_colmap_model(const std::string& where, const std::string& what);

/// COLMAP's name of a lens model that lumi lacks; empty for ids that are none of COLMAP's, too.
[[nodiscard]] std::string_view name_of_foreign_lens_model(int id);
[[nodiscard]] bool is_foreign_lens_model(std::string_view name);
/// Throws Error (E-COLMAP-LENS) with a way out.
[[noreturn]] void refuse_foreign_lens_model(const std::string& where, std::uint32_t camera_id,
                                            std::string_view model);

}  // namespace lumi
