#include "tests/calib/mapping/matched_scene.h"

#include <algorithm>
#include <map>
#include <random>

#include "calib/poses/pose_comparison.h"

namespace lumi {
namespace {

struct TrackEnd {
    int photograph = 0;
    std::uint32_t feature = 0;
};

NamedPoses poses_of(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

}  // namespace

MatchedScene matched_scene(Capture truth) {
    MatchedScene scene;
    for (const Camera& camera : truth.cameras) scene.cameras.push_back({camera, true});
    for (const View& view : truth.views) scene.photographs.push_back({view.camera_index, {}});
    std::map<std::pair<int, int>, std::vector<FeatureMatch>> matches;
    for (const ScenePoint& point : truth.points) {
        std::vector<TrackEnd> ends;
        for (const Observation& seen : point.track) {
            auto& keypoints =
                scene.photographs[static_cast<std::size_t>(seen.view_index)].keypoints_px;
            ends.push_back({seen.view_index, static_cast<std::uint32_t>(keypoints.size())});
            keypoints.push_back(seen.pixel.cast<float>());
        }
        for (std::size_t a = 0; a < ends.size(); ++a) {
            for (std::size_t b = a + 1; b < ends.size(); ++b) {
                matches[{ends[a].photograph, ends[b].photograph}].push_back(
                    {ends[a].feature, ends[b].feature});
            }
        }
    }
    for (const auto& [photographs, inliers] : matches) {
        scene.pairs.push_back(
            {photographs.first, photographs.second, PairConfiguration::kUncalibrated, inliers});
    }
    scene.truth = std::move(truth);
    return scene;
}

void confuse_matches(MatchedScene& scene, double share, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    for (VerifiedPair& pair : scene.pairs) {
        const std::size_t features =
            scene.photographs[static_cast<std::size_t>(pair.second)].keypoints_px.size();
        for (FeatureMatch& match : pair.inliers) {
            if (unit(random) >= share) continue;
            match.second = static_cast<std::uint32_t>(random() % features);
        }
    }
}

double relative_position_error(const Capture& estimate, const Capture& truth) {
    double extent = 0;
    for (const View& a : truth.views) {
        for (const View& b : truth.views) {
            extent = std::max(
                extent,
                (centre_in_world(a.cam_from_world) - centre_in_world(b.cam_from_world)).norm());
        }
    }
    return compare_poses(poses_of(estimate), poses_of(truth)).max_position / extent;
}

std::vector<std::string> names_of(const Capture& capture) {
    std::vector<std::string> names;
    for (const View& view : capture.views) names.push_back(view.name);
    return names;
}

}  // namespace lumi
