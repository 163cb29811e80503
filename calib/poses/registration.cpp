#include "calib/poses/registration.h"

#include <algorithm>
#include <set>
#include <string>

namespace lumi {
namespace {

/// The pairs with placed photographs.
struct Links {
    int count = 0;
    std::size_t most_matches = 0;
    int strongest = -1;  ///< The placed photograph of the pair with most matches.
};

Links links_of(int photograph, const std::vector<char>& is_placed,
               const std::vector<VerifiedPair>& pairs) {
    Links links;
    for (const VerifiedPair& pair : pairs) {
        if (pair.first != photograph && pair.second != photograph) continue;
        const int other = pair.first == photograph ? pair.second : pair.first;
        if (is_placed[static_cast<std::size_t>(other)] == 0) continue;
        ++links.count;
        if (pair.inliers.size() <= links.most_matches) continue;
        links.most_matches = pair.inliers.size();
        links.strongest = other;
    }
    return links;
}

/// Why a photograph with links could not be placed.
std::string weakness_of(const Links& links, const std::string& strongest_name) {
    constexpr std::size_t kManyMatches = 50;
    const std::string matches = std::to_string(links.most_matches) + " matches";
    if (links.most_matches <= kManyMatches) {
        return "shares too little with the placed photographs (at most " + matches + ", with " +
               strongest_name + ")";
    }
    if (links.count == 1) {
        return "shows what only one of the placed photographs shows (" + strongest_name + ", " +
               matches + "): it takes two to know how far away that is";
    }
    return "has " + matches + " with " + strongest_name +
           ", but fits no place that the placed photographs leave it";
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
        const Links links = links_of(static_cast<int>(index), is_placed, pairs);
        if (count < kHardlyAnyFeatures) {
            result.push_back({name, "E-POSES-NOFEATURES",
                              "hardly any detail (" + std::to_string(count) +
                                  " features): blurred, dark, or without texture"});
        } else if (links.strongest < 0) {
            result.push_back({name, "E-POSES-NOMATCH",
                              "shows nothing that a placed photograph shows: overlap is missing"});
        } else {
            const std::string& strongest =
                photographs[static_cast<std::size_t>(links.strongest)].name;
            result.push_back({name, "E-POSES-WEAK", weakness_of(links, strongest)});
        }
    }
    return result;
}

}  // namespace lumi
