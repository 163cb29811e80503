#include "calib/poses/imported_pose_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "calib/capture/angle_between.h"
#include "calib/capture/one_place.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/poses/imported_model_check.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr int kLeastPairs = 3;

/// Of a direction from the shorter arc between two others.
double angle_from_arc(const Eigen::Vector3d& direction, const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to) {
    const double at_ends = std::min(angle_between(direction, from), angle_between(direction, to));
    const Eigen::Vector3d normal = from.cross(to);
    const bool is_beside = normal.cross(from).dot(direction) > 0 &&
                           to.cross(normal).dot(direction) > 0 && normal.norm() > 1e-12;
    if (!is_beside) return at_ends;
    return std::abs(
        std::asin(std::clamp(direction.normalized().dot(normal.normalized()), -1.0, 1.0)));
}

Eigen::Vector2d turned(const Eigen::Vector2d& pixel, const Camera& camera, int quarter_turns) {
    const Eigen::Vector2d centre(0.5 * camera.width_px, 0.5 * camera.height_px);
    Eigen::Vector2d from_centre = pixel - centre;
    for (int turn = 0; turn < quarter_turns; ++turn) {
        from_centre = Eigen::Vector2d(-from_centre.y(), from_centre.x());
    }
    return centre + from_centre;
}

/// Of the matches, were both pictures turned.
std::vector<double> errors_px(const Capture& capture,
                              const std::vector<ColmapPhotograph>& photographs,
                              const VerifiedPair& pair, int quarter_turns) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    const View& first_view = capture.views[first];
    const View& second_view = capture.views[second];
    const Camera& first_camera = camera_of(capture, first_view);
    const Camera& second_camera = camera_of(capture, second_view);
    std::vector<double> errors;
    for (const FeatureMatch& match : pair.inliers) {
        errors.push_back(distance_from_ray_px(
            first_camera, first_view.cam_from_world,
            turned(photographs[first].keypoints_px[match.first].cast<double>(), first_camera,
                   quarter_turns),
            second_camera, second_view.cam_from_world,
            turned(photographs[second].keypoints_px[match.second].cast<double>(), second_camera,
                   quarter_turns)));
    }
    return errors;
}

/// Clearly less than they are as stored, where that is worse than features are found.
bool fits_better_turned(const Capture& capture, const std::vector<ColmapPhotograph>& photographs,
                        const VerifiedPair& pair, double error_px) {
    constexpr double kLeastError_px = 0.5;
    constexpr double kShare = 0.6;
    if (error_px < kLeastError_px) return false;
    const Camera& camera = camera_of(capture, capture.views[static_cast<std::size_t>(pair.second)]);
    for (const int quarter_turns : {1, 2, 3}) {
        // Others would have another shape.
        if (quarter_turns != 2 && camera.width_px != camera.height_px) continue;
        const double turned_px = median_of(errors_px(capture, photographs, pair, quarter_turns));
        if (turned_px < kShare * error_px) return true;
    }
    return false;
}

/// The view that looks the same way, to 60 degrees, from the nearest place that is another.
std::optional<int> neighbour_of(const Capture& capture, int index) {
    constexpr double kLeastCosine = 0.5;
    const Rigid3& pose = capture.views[static_cast<std::size_t>(index)].cam_from_world;
    std::optional<int> nearest;
    double nearest_distance = std::numeric_limits<double>::infinity();
    for (int other = 0; other < static_cast<int>(capture.views.size()); ++other) {
        const Rigid3& candidate = capture.views[static_cast<std::size_t>(other)].cam_from_world;
        const double distance = (centre_in_world(candidate) - centre_in_world(pose)).norm();
        const double cosine = optical_axis_in_world(candidate).dot(optical_axis_in_world(pose));
        if (are_at_one_place(pose, candidate) || cosine < kLeastCosine) continue;
        if (distance >= nearest_distance) continue;
        nearest = other;
        nearest_distance = distance;
    }
    return nearest;
}

/// Of eight views and their neighbours.
std::vector<std::pair<int, int>> pairs_to_check(const Capture& capture) {
    constexpr int kViews = 8;
    const int count = static_cast<int>(capture.views.size());
    std::set<std::pair<int, int>> pairs;
    for (int number = 0; number < std::min(kViews, count); ++number) {
        const int index = number * count / std::min(kViews, count);
        if (const auto other = neighbour_of(capture, index)) {
            pairs.emplace(std::min(index, *other), std::max(index, *other));
        }
    }
    return {pairs.begin(), pairs.end()};
}

std::set<int> views_of(const std::vector<std::pair<int, int>>& pairs) {
    std::set<int> views;
    for (const auto& [first, second] : pairs) views.insert({first, second});
    return views;
}

std::set<int> views_to_compare(const Capture& capture) {
    constexpr int kViews = 64;
    const int count = static_cast<int>(capture.views.size());
    std::set<int> views;
    for (int number = 0; number < std::min(kViews, count); ++number) {
        views.insert(number * count / std::min(kViews, count));
    }
    return views;
}

/// Of these views, in the order of all.
std::vector<Features> features_of(const Capture& capture, const std::vector<Photograph>& all,
                                  const std::filesystem::path& mask_folder,
                                  const std::set<int>& views, int threads, Progress& progress) {
    constexpr int kMostFeatures = 2048;
    std::map<std::string, const Photograph*> by_name;
    for (const Photograph& photograph : all) by_name[photograph.name] = &photograph;
    std::vector<Photograph> photographs;
    for (const int view : views) {
        photographs.push_back(*by_name.at(capture.views[static_cast<std::size_t>(view)].name));
    }
    std::vector<Features> found = detect_features(
        photographs, mask_folder, {.max_features = kMostFeatures}, threads, progress);
    std::vector<Features> features(capture.views.size());
    auto next = found.begin();
    for (const int view : views) features[static_cast<std::size_t>(view)] = std::move(*next++);
    return features;
}

/// Matches that an epipolar geometry holds for against the poses. It is found from what is seen
/// and the lens, without the poses: those may be wrong.
PoseCheck check_matches(const Capture& capture, const std::vector<Features>& features,
                        const std::vector<PairMatches>& matches, int min_inliers, int threads,
                        Progress& progress) {
    std::vector<ColmapCamera> cameras;
    for (const Camera& camera : capture.cameras) cameras.push_back({camera, true});
    std::vector<ColmapPhotograph> keypoints;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        keypoints.push_back({capture.views[view].camera_index, {}});
        for (const Keypoint& keypoint : features[view].keypoints) {
            keypoints.back().keypoints_px.push_back(keypoint.pixel);
        }
    }
    return check_poses(capture, keypoints,
                       verify_pairs(matches, cameras, keypoints, false,
                                    {.min_inliers = min_inliers}, threads, progress));
}

}  // namespace

double distance_from_ray_px(const Camera& first, const Rigid3& first_from_world,
                            const Eigen::Vector2d& pixel_in_first, const Camera& second,
                            const Rigid3& second_from_world,
                            const Eigen::Vector2d& pixel_in_second) {
    const Rigid3 second_from_first = second_from_world * inverse(first_from_world);
    const Eigen::Vector3d infinitely_far =
        second_from_first.rotation * unproject(first, pixel_in_first);
    const Eigen::Vector3d& at_first = second_from_first.translation;
    const Eigen::Vector3d seen = unproject(second, pixel_in_second);
    const double angle = are_at_one_place(first_from_world, second_from_world)
                             ? angle_between(seen, infinitely_far)
                             : angle_from_arc(seen, at_first, infinitely_far);
    return angle * focal_length_px(second).mean();
}

PoseCheck check_poses(const Capture& capture, const std::vector<ColmapPhotograph>& photographs,
                      const std::vector<VerifiedPair>& pairs) {
    PoseCheck check;
    check.pairs_asked = static_cast<int>(pairs.size());
    std::vector<double> all;
    for (const VerifiedPair& pair : pairs) {
        const std::vector<double> errors = errors_px(capture, photographs, pair, 0);
        const View& second = capture.views[static_cast<std::size_t>(pair.second)];
        const double denied_px = denied_error_px(camera_of(capture, second));
        const double error_px = median_of(errors);
        ++check.pairs;
        if (error_px > denied_px) ++check.pairs_denied;
        if (fits_better_turned(capture, photographs, pair, error_px)) ++check.pairs_turned;
        all.insert(all.end(), errors.begin(), errors.end());
    }
    check.median_error_px = median_of(std::move(all));
    return check;
}

PoseCheck check_imported_poses(const Capture& capture, const std::vector<Photograph>& photographs,
                               const std::filesystem::path& mask_folder, int threads,
                               Progress& progress) {
    const std::vector<std::pair<int, int>> pairs = pairs_to_check(capture);
    std::vector<Features> features =
        features_of(capture, photographs, mask_folder, views_of(pairs), threads, progress);
    PoseCheck check =
        check_matches(capture, features, match_pairs(features, pairs, {}, threads, progress),
                      PairVerificationOptions{}.min_inliers, threads, progress);
    check.pairs_asked = static_cast<int>(pairs.size());
    if (check.pairs_asked > 0 && 2 * check.pairs >= check.pairs_asked) return check;
    // Photographs that surely show the same things tell whether it is the poses that are wrong.
    constexpr int kSurelyTheSame = 40;
    features = features_of(capture, photographs, mask_folder, views_to_compare(capture), threads,
                           progress);
    PoseCheck by_look =
        check_matches(capture, features, match_photographs(features, threads, progress),
                      kSurelyTheSame, threads, progress);
    by_look.pairs_asked = check.pairs_asked;
    return by_look.pairs_denied > 0 || check.pairs_asked == 0 ? by_look : check;
}

std::string warning_of(const PoseCheck& check) {
    const std::string of_pairs = " of " + std::to_string(check.pairs) + " pairs of photographs ";
    // Where the poses make no neighbours, things that look alike from all sides match as well: then
    // only many, and all of them, tell.
    const bool is_told =
        check.pairs_asked == 0
            ? check.pairs >= kLeastPairs && check.pairs_denied == check.pairs
            : check.pairs > 0 && check.pairs >= std::min(kLeastPairs, check.pairs_asked);
    if (is_told && 2 * check.pairs_turned > check.pairs) {
        throw Error(ErrorKind::kBadInput, "E-IMPORT-TURNED",
                    std::to_string(check.pairs_turned) + of_pairs +
                        "fit the imported poses only when they are turned on the spot: the other "
                        "program turned the photographs upright (EXIF orientation), lumi does not",
                    "give the photographs as that program wrote them, or let lumi estimate the "
                    "poses");
    }
    const std::string denied =
        std::to_string(check.pairs_denied) + of_pairs + "deny the imported poses: " +
        formatted("half of all matches are %.0f px or more from where they would have to be",
                  check.median_error_px);
    if (is_told && 2 * check.pairs_denied > check.pairs) refuse_imported_poses(denied);
    if (check.pairs_denied > 0) return denied;
    if (check.pairs == 0)
        return "nothing confirms the imported poses: no pair of photographs tells";
    if (2 * check.pairs >= check.pairs_asked) return {};
    return "little confirms the imported poses: " + std::to_string(check.pairs) + " of " +
           std::to_string(check.pairs_asked) +
           " pairs of photographs that are neighbours by them show the same things";
}

}  // namespace lumi
