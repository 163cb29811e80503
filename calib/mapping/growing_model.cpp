#include "calib/mapping/growing_model.h"

#include <algorithm>
#include <numeric>

namespace lumi {
namespace {

void index_features(GrowingModel& model) {
    model.track_of_feature.clear();
    for (const auto& features : model.pixels)
        model.track_of_feature.emplace_back(features.size(), -1);
    for (std::size_t track = 0; track < model.tracks.size(); ++track) {
        for (const TrackElement& element : model.tracks[track].elements) {
            model.track_of_feature[static_cast<std::size_t>(element.photograph)][element.feature] =
                static_cast<int>(track);
        }
    }
}

/// Marks the sightings that agree with the track's point.
void judge_sightings(GrowingTrack& track, const Eigen::Vector3d& point_in_world,
                     const TrackSightings& seen, double max_error_px) {
    std::fill(track.is_inlier.begin(), track.is_inlier.end(), char{0});
    for (std::size_t index = 0; index < seen.sightings.size(); ++index) {
        const double error_px = sighting_error_px(seen.sightings[index], point_in_world);
        if (error_px <= max_error_px) track.is_inlier[seen.elements[index]] = 1;
    }
}

std::vector<char> inliers_among(const GrowingTrack& track, const TrackSightings& seen) {
    std::vector<char> is_used;
    for (const std::size_t element : seen.elements) is_used.push_back(track.is_inlier[element]);
    return is_used;
}

void triangulate_track(GrowingModel& model, std::size_t index,
                       const TriangulationOptions& options) {
    const TrackSightings seen = sightings_of(model, index);
    if (seen.sightings.size() < 2) return;
    GrowingTrack& track = model.tracks[index];
    if (track.point_in_world) {
        judge_sightings(track, *track.point_in_world, seen, options.max_error_px);
        return;
    }
    const auto point = triangulate(seen.sightings, options);
    if (!point) return;
    track.point_in_world = point->position_in_world;
    for (std::size_t sighting = 0; sighting < seen.elements.size(); ++sighting) {
        track.is_inlier[seen.elements[sighting]] = point->is_inlier[sighting];
    }
}

}  // namespace

int GrowingTrack::inliers() const {
    return static_cast<int>(std::count(is_inlier.begin(), is_inlier.end(), char{1}));
}

void GrowingTrack::forget_point() {
    point_in_world.reset();
    std::fill(is_inlier.begin(), is_inlier.end(), char{0});
}

int GrowingModel::placed() const {
    return static_cast<int>(std::count(is_placed.begin(), is_placed.end(), char{1}));
}

std::size_t GrowingModel::point_count() const {
    return static_cast<std::size_t>(
        std::count_if(tracks.begin(), tracks.end(),
                      [](const GrowingTrack& track) { return track.point_in_world.has_value(); }));
}

GrowingModel unplaced_model(const std::vector<ColmapCamera>& cameras,
                            const std::vector<ColmapPhotograph>& photographs,
                            const std::vector<VerifiedPair>& pairs) {
    GrowingModel model;
    for (const ColmapCamera& camera : cameras) model.cameras.push_back(camera.camera);
    std::vector<std::size_t> feature_counts;
    for (const ColmapPhotograph& photograph : photographs) {
        model.camera_of_photograph.push_back(photograph.camera_index);
        feature_counts.push_back(photograph.keypoints_px.size());
        std::vector<Eigen::Vector2d> pixels;
        for (const Eigen::Vector2f& pixel : photograph.keypoints_px) {
            pixels.push_back(pixel.cast<double>());
        }
        model.rays.emplace_back(pixels.size(), Eigen::Vector2d::Zero());
        model.pixels.push_back(std::move(pixels));
    }
    model.is_placed.assign(photographs.size(), 0);
    model.cam_from_world.resize(photographs.size());
    for (FeatureTrack& elements : join_tracks(feature_counts, pairs)) {
        std::vector<char> is_inlier(elements.size(), 0);
        model.tracks.push_back({std::move(elements), std::move(is_inlier), std::nullopt});
    }
    index_features(model);
    update_rays(model);
    return model;
}

void update_rays(GrowingModel& model) {
    for (std::size_t photograph = 0; photograph < model.pixels.size(); ++photograph) {
        const Camera& camera = model.camera_of(static_cast<int>(photograph));
        for (std::size_t feature = 0; feature < model.pixels[photograph].size(); ++feature) {
            if (model.track_of_feature[photograph][feature] < 0) continue;
            model.rays[photograph][feature] =
                unproject(camera, model.pixels[photograph][feature]).head<2>();
        }
    }
}

TrackSightings sightings_of(const GrowingModel& model, std::size_t track) {
    TrackSightings seen;
    const FeatureTrack& elements = model.tracks[track].elements;
    for (std::size_t element = 0; element < elements.size(); ++element) {
        const auto photograph = static_cast<std::size_t>(elements[element].photograph);
        if (model.is_placed[photograph] == 0) continue;
        seen.sightings.push_back(
            {model.cam_from_world[photograph], model.rays[photograph][elements[element].feature],
             focal_length_px(model.camera_of(static_cast<int>(photograph))).mean()});
        seen.elements.push_back(element);
    }
    return seen;
}

void triangulate_tracks(GrowingModel& model, const std::vector<std::size_t>& tracks,
                        const TriangulationOptions& options) {
    for (const std::size_t track : tracks) triangulate_track(model, track, options);
}

void triangulate_all_tracks(GrowingModel& model, const TriangulationOptions& options) {
    for (std::size_t track = 0; track < model.tracks.size(); ++track) {
        triangulate_track(model, track, options);
    }
}

void judge_points(GrowingModel& model, const TriangulationOptions& options) {
    for (std::size_t index = 0; index < model.tracks.size(); ++index) {
        GrowingTrack& track = model.tracks[index];
        if (!track.point_in_world) continue;
        const TrackSightings seen = sightings_of(model, index);
        Eigen::Vector3d& point = *track.point_in_world;
        point = refined_point(seen.sightings, inliers_among(track, seen), point);
        judge_sightings(track, point, seen, options.max_error_px);
        if (track.inliers() < 2 || !(largest_angle_rad(seen.sightings, inliers_among(track, seen),
                                                       point) >= options.min_angle_rad)) {
            track.forget_point();
        }
    }
}

std::vector<std::size_t> tracks_of(const GrowingModel& model, int photograph) {
    std::vector<std::size_t> tracks;
    for (const int track : model.track_of_feature[static_cast<std::size_t>(photograph)]) {
        if (track >= 0) tracks.push_back(static_cast<std::size_t>(track));
    }
    return tracks;
}

SeenPoints seen_points(const GrowingModel& model, int photograph) {
    SeenPoints seen;
    const auto position = static_cast<std::size_t>(photograph);
    const std::vector<int>& tracks = model.track_of_feature[position];
    for (std::size_t feature = 0; feature < tracks.size(); ++feature) {
        if (tracks[feature] < 0) continue;
        const auto track = static_cast<std::size_t>(tracks[feature]);
        const std::optional<Eigen::Vector3d>& point_in_world = model.tracks[track].point_in_world;
        if (!point_in_world) continue;
        seen.tracks.push_back(track);
        seen.points_in_world.push_back(*point_in_world);
        seen.pixels.push_back(model.pixels[position][feature]);
        seen.rays.push_back(model.rays[position][feature]);
    }
    return seen;
}

Capture capture_of(const GrowingModel& model, const std::vector<std::string>& names) {
    Capture capture;
    std::vector<int> new_camera(model.cameras.size(), -1);
    std::vector<int> new_view(names.size(), -1);
    for (std::size_t photograph = 0; photograph < names.size(); ++photograph) {
        if (model.is_placed[photograph] == 0) continue;
        const auto camera = static_cast<std::size_t>(model.camera_of_photograph[photograph]);
        if (new_camera[camera] < 0) {
            new_camera[camera] = static_cast<int>(capture.cameras.size());
            capture.cameras.push_back(model.cameras[camera]);
        }
        new_view[photograph] = static_cast<int>(capture.views.size());
        capture.views.push_back(
            {names[photograph], new_camera[camera], model.cam_from_world[photograph]});
    }
    for (const GrowingTrack& track : model.tracks) {
        if (!track.point_in_world) continue;
        ScenePoint point;
        point.position_in_world = *track.point_in_world;
        for (std::size_t element = 0; element < track.elements.size(); ++element) {
            if (track.is_inlier[element] == 0) continue;
            const TrackElement& seen = track.elements[element];
            const auto photograph = static_cast<std::size_t>(seen.photograph);
            point.track.push_back({new_view[photograph], model.pixels[photograph][seen.feature]});
        }
        if (point.track.size() >= 2) capture.points.push_back(std::move(point));
    }
    return capture;
}

}  // namespace lumi
