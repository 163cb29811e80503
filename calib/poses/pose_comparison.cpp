#include "calib/poses/pose_comparison.h"

#include <algorithm>
#include <numbers>
#include <numeric>

#include "calib/capture/colmap_model.h"
#include "calib/known_poses/strecha_camera.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr const char* kStrechaEnding = ".camera";

/// The file name without folders and without its last ending.
std::string stem_of(const std::string& name) { return std::filesystem::path(name).stem().string(); }

struct MatchedPose {
    std::string name;
    PosePair pose;
};

std::vector<MatchedPose> matched(const NamedPoses& a, const NamedPoses& b) {
    std::map<std::string, const Rigid3*> b_by_stem;
    for (const auto& [name, pose] : b) b_by_stem[stem_of(name)] = &pose;
    std::vector<MatchedPose> matches;
    for (const auto& [name, pose] : a) {
        const auto same_name = b.find(name);
        if (same_name != b.end()) {
            matches.push_back({name, {pose, same_name->second}});
        } else if (const auto same_stem = b_by_stem.find(stem_of(name));
                   same_stem != b_by_stem.end()) {
            matches.push_back({name, {pose, *same_stem->second}});
        }
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

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 == 1 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
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
    comparison.median_position = median(positions);
    comparison.mean_position = std::accumulate(positions.begin(), positions.end(), 0.0) /
                               static_cast<double>(positions.size());
    comparison.max_position = *std::max_element(positions.begin(), positions.end());
    comparison.median_rotation_deg = median(rotations);
    comparison.max_rotation_deg = *std::max_element(rotations.begin(), rotations.end());
    return comparison;
}

}  // namespace lumi
