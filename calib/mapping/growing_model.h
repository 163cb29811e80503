#pragma once

#include <optional>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/mapping/feature_tracks.h"
#include "calib/mapping/triangulation.h"

namespace lumi {

/// A track and what the model knows of it.
struct GrowingTrack {
    FeatureTrack elements;
    std::vector<char> is_inlier;  ///< Of each element, whether it agrees with the point.
    std::optional<Eigen::Vector3d> point_in_world;

    [[nodiscard]] int inliers() const;
    /// Keeps the elements, and nothing that was found out about them.
    void forget_point();

    friend bool operator==(const GrowingTrack&, const GrowingTrack&) = default;
};

/// A reconstruction while photographs are added to it. Vectors are parallel: one entry per lens or
/// per photograph.
struct GrowingModel {
    std::vector<Camera> cameras;
    std::vector<int> camera_of_photograph;
    std::vector<std::vector<Eigen::Vector2d>> pixels;  ///< [photograph][feature]
    std::vector<std::vector<Eigen::Vector2d>> rays;    ///< The same at depth 1, by `cameras`.
    std::vector<std::vector<int>> track_of_feature;    ///< [photograph][feature]; -1: none.

    std::vector<char> is_placed;
    std::vector<Rigid3> cam_from_world;  ///< Of the placed photographs.

    std::vector<GrowingTrack> tracks;

    [[nodiscard]] const Camera& camera_of(int photograph) const {
        return cameras[static_cast<std::size_t>(
            camera_of_photograph[static_cast<std::size_t>(photograph)])];
    }
    [[nodiscard]] int placed() const;
    [[nodiscard]] std::size_t point_count() const;
};

/// A model without a placed photograph; features that no track uses are forgotten.
[[nodiscard]] GrowingModel unplaced_model(const std::vector<ColmapCamera>& cameras,
                                          const std::vector<ColmapPhotograph>& photographs,
                                          const std::vector<VerifiedPair>& pairs);

/// Brings `rays` of all tracked features up to date with the lenses.
void update_rays(GrowingModel& model);

/// The placed photographs' sightings of a track, and which element of the track each is.
struct TrackSightings {
    std::vector<Sighting> sightings;
    std::vector<std::size_t> elements;
};
[[nodiscard]] TrackSightings sightings_of(const GrowingModel& model, std::size_t track);

/// Gives points to the tracks that have none and that enough placed photographs agree on, and lets
/// tracks that have one take in the sightings that agree with it.
void triangulate_tracks(GrowingModel& model, const std::vector<std::size_t>& tracks,
                        const TriangulationOptions& options);
void triangulate_all_tracks(GrowingModel& model, const TriangulationOptions& options);

/// Moves each point to where its inliers see it best, judges all sightings again, and takes the
/// point from tracks that fewer than two agree on or whose rays have become nearly parallel.
void judge_points(GrowingModel& model, const TriangulationOptions& options);

/// Tracks that a photograph shows, ascending by feature.
[[nodiscard]] std::vector<std::size_t> tracks_of(const GrowingModel& model, int photograph);

/// What one photograph sees of the model's points.
struct SeenPoints {
    std::vector<std::size_t> tracks;
    std::vector<Eigen::Vector3d> points_in_world;
    std::vector<Eigen::Vector2d> pixels;
    std::vector<Eigen::Vector2d> rays;
};
[[nodiscard]] SeenPoints seen_points(const GrowingModel& model, int photograph);

/// The placed photographs and the points that at least two of them see; `names` has one name per
/// photograph. Lenses without a placed photograph are left out.
[[nodiscard]] Capture capture_of(const GrowingModel& model, const std::vector<std::string>& names);

}  // namespace lumi
