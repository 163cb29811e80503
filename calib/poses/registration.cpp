#include "calib/poses/registration.h"

#include <algorithm>
#include <set>
#include <string>

namespace lumi {
namespace {

constexpr std::size_t kFewFeatures = 50;

/// The pair with a placed photograph that has most matches.
struct StrongestLink {
    std::size_t matches = 0;
    int other = -1;
};

StrongestLink strongest_link(int photograph, const std::vector<char>& is_placed,
                             const std::vector<VerifiedPair>& pairs) {
    StrongestLink link;
    for (const VerifiedPair& pair : pairs) {
        if (pair.first != photograph && pair.second != photograph) continue;
        const int other = pair.first == photograph ? pair.second : pair.first;
        if (is_placed[static_cast<std::size_t>(other)] == 0) continue;
        if (pair.inliers.size() > link.matches) link = {pair.inliers.size(), other};
    }
    return link;
}

}  // namespace

void drop_weak_views(Capture& capture, std::size_t min_points) {
    std::vector<std::size_t> points_of_view(capture.views.size(), 0);
    for (const ScenePoint& point : capture.points) {
        for (const Observation& observation : point.track) {
            ++points_of_view[static_cast<std::size_t>(observation.view_index)];
        }
    }
    std::vector<char> is_dropped;
    for (const std::size_t points : points_of_view) is_dropped.push_back(points < min_points);
    drop_views(capture, is_dropped);
}

void drop_views(Capture& capture, const std::vector<char>& is_dropped) {
    std::vector<int> new_index(capture.views.size(), -1);
    std::vector<View> kept;
    for (std::size_t index = 0; index < capture.views.size(); ++index) {
        if (is_dropped[index] != 0) continue;
        new_index[index] = static_cast<int>(kept.size());
        kept.push_back(std::move(capture.views[index]));
    }
    capture.views = std::move(kept);
    for (ScenePoint& point : capture.points) {
        for (Observation& observation : point.track) {
            observation.view_index = new_index[static_cast<std::size_t>(observation.view_index)];
        }
        std::erase_if(point.track, [](const Observation& seen) { return seen.view_index < 0; });
    }
    std::erase_if(capture.points, [](const ScenePoint& point) { return point.track.size() < 2; });
}

std::vector<std::size_t> drop_unused_cameras(Capture& capture) {
    std::vector<int> new_index(capture.cameras.size(), -1);
    for (const View& view : capture.views) {
        new_index[static_cast<std::size_t>(view.camera_index)] = 0;
    }
    std::vector<std::size_t> left;
    std::vector<Camera> used;
    for (std::size_t index = 0; index < capture.cameras.size(); ++index) {
        if (new_index[index] < 0) continue;
        new_index[index] = static_cast<int>(left.size());
        left.push_back(index);
        used.push_back(std::move(capture.cameras[index]));
    }
    for (View& view : capture.views) {
        view.camera_index = new_index[static_cast<std::size_t>(view.camera_index)];
    }
    capture.cameras = std::move(used);
    return left;
}

std::vector<LeftOut> explain_unregistered(const Capture& capture,
                                          const std::vector<Photograph>& photographs,
                                          const std::vector<ColmapPhotograph>& features,
                                          const std::vector<VerifiedPair>& pairs) {
    std::set<std::string> placed_names;
    for (const View& view : capture.views) placed_names.insert(view.name);
    std::vector<char> is_placed;
    for (const Photograph& photograph : photographs) {
        is_placed.push_back(placed_names.contains(photograph.name) ? 1 : 0);
    }
    std::vector<LeftOut> result;
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        if (is_placed[index] != 0) continue;
        const std::string& name = photographs[index].name;
        const std::size_t count = features[index].keypoints_px.size();
        const StrongestLink link = strongest_link(static_cast<int>(index), is_placed, pairs);
        if (count < kFewFeatures) {
            result.push_back({name, "E-POSES-NOFEATURES",
                              "hardly any detail (" + std::to_string(count) +
                                  " features): blurred, dark, or without texture"});
        } else if (link.other < 0) {
            result.push_back({name, "E-POSES-NOMATCH",
                              "shows nothing that a placed photograph shows: overlap is missing"});
        } else {
            result.push_back({name, "E-POSES-WEAK",
                              "shares too little with the placed photographs (at most " +
                                  std::to_string(link.matches) + " matches, with " +
                                  photographs[static_cast<std::size_t>(link.other)].name + ")"});
        }
    }
    return result;
}

}  // namespace lumi
