#include "calib/mapping/before_placement.h"

namespace lumi {

BeforePlacement::BeforePlacement(const GrowingModel& model, int photograph)
    : photograph_(static_cast<std::size_t>(photograph)),
      lens_(model.camera_of(photograph)),
      cam_from_world_(model.cam_from_world),
      is_placed_(model.is_placed[photograph_]) {
    for (const std::size_t index : tracks_of(model, photograph)) {
        tracks_.push_back({index, model.tracks[index]});
    }
}

void BeforePlacement::restore(GrowingModel& model) const {
    const auto camera = static_cast<std::size_t>(model.camera_of_photograph[photograph_]);
    if (!(model.cameras[camera] == lens_)) {
        model.cameras[camera] = lens_;
        update_rays(model);
    }
    model.cam_from_world = cam_from_world_;
    model.is_placed[photograph_] = is_placed_;
    for (const TrackBefore& before : tracks_) model.tracks[before.index] = before.track;
}

}  // namespace lumi
