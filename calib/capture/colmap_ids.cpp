#include "calib/capture/colmap_ids.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/work/error.h"

namespace lumi {
namespace {

struct ForeignLensModel {
    int id;
    std::string_view name;
};

/// COLMAP 3.8, base/camera_models.h, and what came since.
constexpr std::array<ForeignLensModel, 5> kForeignLensModels{{{7, "FOV"},
                                                              {8, "SIMPLE_RADIAL_FISHEYE"},
                                                              {9, "RADIAL_FISHEYE"},
                                                              {10, "THIN_PRISM_FISHEYE"},
                                                              {11, "RAD_TAN_THIN_PRISM_FISHEYE"}}};

/// View indices by image id, in the order of names.
std::map<std::uint32_t, int> view_indices_by_name(const ColmapRecords& records) {
    std::vector<std::pair<std::string, std::uint32_t>> names;
    for (const auto& [id, image] : records.images) names.emplace_back(image.view.name, id);
    std::sort(names.begin(), names.end());
    std::map<std::uint32_t, int> indices;
    for (const auto& [name, id] : names) indices.emplace(id, static_cast<int>(indices.size()));
    return indices;
}

}  // namespace

void refuse_colmap_model(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-COLMAP-MODEL", where + ": " + what,
                "the model is damaged or not COLMAP's: export it again with "
                "`colmap model_converter`");
}

std::string_view name_of_foreign_lens_model(int id) {
    for (const ForeignLensModel& model : kForeignLensModels) {
        if (model.id == id) return model.name;
    }
    return {};
}

bool is_foreign_lens_model(std::string_view name) {
    return std::any_of(kForeignLensModels.begin(), kForeignLensModels.end(),
                       [&](const ForeignLensModel& model) { return model.name == name; });
}

void refuse_foreign_lens_model(const std::string& where, std::uint32_t camera_id,
                               std::string_view model) {
    throw Error(ErrorKind::kBadInput, "E-COLMAP-LENS",
                where + ": camera " + std::to_string(camera_id) + " has the lens model " +
                    std::string(model) + ", which lumi lacks",
                "straighten the photographs with `colmap image_undistorter` and give those with "
                "the model it writes, or let COLMAP fit OPENCV_FISHEYE");
}

Eigen::Quaterniond checked_unit(const Eigen::Quaterniond& rotation) {
    constexpr double kRoundingTolerance = 0.01;
    constexpr double kExact = 1e-15;
    const double error = std::abs(rotation.norm() - 1);
    if (error < kExact || !(error < kRoundingTolerance)) return rotation;
    return rotation.normalized();
}

Capture capture_from_records(const ColmapRecords& records, const std::string& where) {
    Capture capture;
    std::map<std::uint32_t, int> camera_indices;
    for (const auto& [id, camera] : records.cameras) {
        camera_indices.emplace(id, static_cast<int>(capture.cameras.size()));
        capture.cameras.push_back(camera);
    }
    const std::map<std::uint32_t, int> view_indices = view_indices_by_name(records);
    capture.views.resize(records.images.size());
    for (const auto& [id, image] : records.images) {
        const auto camera = camera_indices.find(image.camera_id);
        if (camera == camera_indices.end()) {
            refuse_colmap_model(where, image.view.name + " names camera " +
                                           std::to_string(image.camera_id) +
                                           ", which does not exist");
        }
        View& view = capture.views[static_cast<std::size_t>(view_indices.at(id))];
        view = image.view;
        view.camera_index = camera->second;
    }
    for (const auto& [id, record] : records.points) {
        ScenePoint point = record.point;
        for (const auto& [image_id, keypoint] : record.track) {
            const auto image = records.images.find(image_id);
            if (image == records.images.end() || keypoint >= image->second.keypoints_px.size()) {
                refuse_colmap_model(where, "point " + std::to_string(id) +
                                               " is seen by an image or keypoint that does not "
                                               "exist");
            }
            point.track.push_back(
                {view_indices.at(image_id), image->second.keypoints_px[keypoint]});
        }
        capture.points.push_back(std::move(point));
    }
    validate(capture, where);
    return capture;
}

ColmapKeypoints keypoints_of(const Capture& capture) {
    ColmapKeypoints keypoints;
    keypoints.by_view.resize(capture.views.size());
    keypoints.index_in_view.resize(capture.points.size());
    for (std::size_t point = 0; point < capture.points.size(); ++point) {
        for (const Observation& observation : capture.points[point].track) {
            auto& of_view = keypoints.by_view[static_cast<std::size_t>(observation.view_index)];
            keypoints.index_in_view[point].push_back(of_view.size());
            of_view.emplace_back(observation.pixel, point);
        }
    }
    return keypoints;
}

}  // namespace lumi
