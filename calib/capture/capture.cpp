#include "calib/capture/capture.h"

#include <cmath>
#include <set>

#include "calib/work/error.h"

namespace lumi {
namespace {

bool in_range(int index, std::size_t count) {
    return index >= 0 && static_cast<std::size_t>(index) < count;
}

}  // namespace

void validate(const Capture& capture, const std::string& where) {
    const auto refuse = [&](const std::string& what) {
        throw Error(ErrorKind::kBadInput, "E-CAPTURE-INVALID", where + ": " + what,
                    "the model is damaged: export it again, or estimate the poses with lumi");
    };
    for (std::size_t i = 0; i < capture.cameras.size(); ++i) {
        validate(capture.cameras[i], where + ": camera " + std::to_string(i + 1));
    }
    std::set<std::string> names;
    for (const View& view : capture.views) {
        if (view.name.empty()) refuse("a view has no name");
        if (!names.insert(view.name).second) refuse("two views are named " + view.name);
        if (!in_range(view.camera_index, capture.cameras.size())) {
            refuse(view.name + ": its camera does not exist");
        }
        if (!is_rigid(view.cam_from_world)) {
            refuse(view.name + ": its pose is not a finite rotation and translation");
        }
    }
    for (std::size_t i = 0; i < capture.points.size(); ++i) {
        const ScenePoint& point = capture.points[i];
        if (!point.position_in_world.allFinite() || !std::isfinite(point.error_px)) {
            refuse("point " + std::to_string(i + 1) + " is not finite");
        }
        for (const Observation& observation : point.track) {
            if (!in_range(observation.view_index, capture.views.size()) ||
                !observation.pixel.allFinite()) {
                refuse("point " + std::to_string(i + 1) + " is seen by a view that does not exist");
            }
        }
    }
}

}  // namespace lumi
