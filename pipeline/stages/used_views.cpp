#include "pipeline/stages/used_views.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "calib/work/error.h"
#include "calib/work/nearest_word.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

constexpr std::size_t kMinTrackLength = 2;

bool contains(const std::vector<std::string>& sorted, const std::string& name) {
    return std::binary_search(sorted.begin(), sorted.end(), name);
}

/// The point as the remaining views see it; `new_index` is -1 for a view that is gone.
ScenePoint seen_by_remaining(const ScenePoint& point, const std::vector<int>& new_index) {
    ScenePoint seen = point;
    seen.track.clear();
    for (const Observation& observation : point.track) {
        const int index = new_index[static_cast<std::size_t>(observation.view_index)];
        if (index >= 0) seen.track.push_back({index, observation.pixel});
    }
    return seen;
}

PosedPhotographs selected(const PosedPhotographs& photographs,
                          const std::function<bool(const View&)>& is_wanted) {
    const Capture& capture = photographs.capture;
    PosedPhotographs result;
    result.capture.cameras = capture.cameras;
    std::vector<int> new_index(capture.views.size(), -1);
    for (std::size_t i = 0; i < capture.views.size(); ++i) {
        if (!is_wanted(capture.views[i])) continue;
        new_index[i] = static_cast<int>(result.capture.views.size());
        result.capture.views.push_back(capture.views[i]);
        result.picture_paths.push_back(photographs.picture_paths[i]);
    }
    for (const ScenePoint& point : capture.points) {
        ScenePoint seen = seen_by_remaining(point, new_index);
        if (point.track.empty() || seen.track.size() >= kMinTrackLength) {
            result.capture.points.push_back(std::move(seen));
        }
    }
    return result;
}

[[noreturn]] void refuse_unknown(const std::string& name,
                                 const std::vector<std::string>& photograph_names,
                                 const HoldOutOptions& options) {
    const std::optional<std::string> meant =
        nearest_word(name, {photograph_names.begin(), photograph_names.end()});
    throw Error(ErrorKind::kUsage, "E-EVAL-NAME",
                (options.place.empty() ? "" : options.place + ": ") +
                    "hold_out: no usable photograph is named " + printable(name),
                (meant ? "did you mean `" + printable(*meant) + "`? " : std::string()) +
                    "use names as in the photographs' folder, with '/' between folders");
}

}  // namespace

std::vector<std::string> view_names(const Capture& capture) {
    std::vector<std::string> names;
    for (const View& view : capture.views) names.push_back(view.name);
    return names;
}

std::vector<std::string> held_out_names(const std::vector<std::string>& photograph_names,
                                        const HoldOutOptions& options) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < photograph_names.size(); ++i) {
        if (options.every > 0 && i % static_cast<std::size_t>(options.every) == 0) {
            names.push_back(photograph_names[i]);
        }
    }
    for (const std::string& name : options.names) {
        const auto end = photograph_names.end();
        if (std::find(photograph_names.begin(), end, name) == end)
            refuse_unknown(name, photograph_names, options);
        names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

PosedPhotographs without_views(const PosedPhotographs& photographs,
                               const std::vector<std::string>& held_out) {
    return selected(photographs, [&](const View& view) { return !contains(held_out, view.name); });
}

PosedPhotographs only_views(const PosedPhotographs& photographs,
                            const std::vector<std::string>& names) {
    return selected(photographs, [&](const View& view) { return contains(names, view.name); });
}

}  // namespace lumi
