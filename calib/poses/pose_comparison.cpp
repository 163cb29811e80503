#include "calib/poses/pose_comparison.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "calib/capture/colmap_model.h"
#include "calib/known_poses/name_matching.h"
#include "calib/known_poses/strecha_camera.h"
#include "calib/work/error.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr const char* kStrechaEnding = ".camera";

struct MatchedPose {
    std::string name;
    PosePair pose;
};

std::vector<std::string> names_of(const NamedPoses& poses) {
    std::vector<std::string> names;
    for (const auto& [name, pose] : poses) names.push_back(name);
    return names;
}

std::vector<MatchedPose> matched(const NamedPoses& a, const NamedPoses& b) {
    const std::vector<std::string> names_of_b = names_of(b);
    const auto index_in_b = matched_names(names_of(a), names_of_b);
    std::vector<MatchedPose> matches;
    auto index = index_in_b.begin();
    for (const auto& [name, pose] : a) {
        if (*index) matches.push_back({name, {pose, b.at(names_of_b[**index])}});
        ++index;
    }
    return matches;
}

PoseDifference difference(const MatchedPose& match, const Similarity3& b_from_a) {
    const Eigen::Vector3d centre =
        b_from_a.scale * (b_from_a.rotation * centre_in_world(match.pose.cam_from_a)) +
        b_from_a.translation;
    const Eigen::Quaterniond cam_from_b =
        match.pose.cam_from_a.rotation * b_from_a.rotation.conjugate();
    return {match.name, (centre - centre_in_world(match.pose.cam_from_b)).norm(),
            cam_from_b.angularDistance(match.pose.cam_from_b.rotation) * 180.0 / std::numbers::pi};
}

}  // namespace

NamedPoses read_named_poses(const std::filesystem::path& folder) {
    NamedPoses poses;
    if (std::filesystem::is_directory(folder)) {
        for (const auto& entry : std::filesystem::directory_iterator(folder)) {
            if (entry.path().extension() != kStrechaEnding) continue;
            poses[entry.path().stem().string()] = read_strecha_camera(entry.path()).cam_from_world;
        }
    }
    if (!poses.empty()) return poses;
    for (const View& view : read_colmap_model(folder).views) poses[view.name] = view.cam_from_world;
    return poses;
}

PoseComparison compare_poses(const NamedPoses& a, const NamedPoses& b) {
    const std::vector<MatchedPose> matches = matched(a, b);
    constexpr std::size_t kMinMatches = 3;
    if (matches.size() < kMinMatches) {
        throw Error(ErrorKind::kBadInput, "E-COMPARE-FEW",
                    "only " + std::to_string(matches.size()) +
                        " photographs have the same name in both, expected at least three",
                    "compare two reconstructions of the same photographs");
    }
    PoseComparison comparison;
    std::vector<PosePair> pairs;
    for (const MatchedPose& match : matches) pairs.push_back(match.pose);
    comparison.b_from_a = fit_centres(pairs);
    std::vector<double> positions;
    std::vector<double> rotations;
    for (const MatchedPose& match : matches) {
        comparison.views.push_back(difference(match, comparison.b_from_a));
        positions.push_back(comparison.views.back().position);
        rotations.push_back(comparison.views.back().rotation_deg);
    }
    comparison.median_position = median_of(positions);
    comparison.mean_position = std::accumulate(positions.begin(), positions.end(), 0.0) /
                               static_cast<double>(positions.size());
    comparison.max_position = *std::max_element(positions.begin(), positions.end());
    comparison.median_rotation_deg = median_of(rotations);
    comparison.max_rotation_deg = *std::max_element(rotations.begin(), rotations.end());
    return comparison;
}

}  // namespace lumi
