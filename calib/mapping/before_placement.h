#pragma once

#include <vector>

#include "calib/mapping/growing_model.h"

namespace lumi {

/// What placing a photograph may change of a model, as it was: the photograph's lens, the poses
/// (adjust_around moves neighbours), and the tracks that it shows.
class BeforePlacement {
 public:
    BeforePlacement(const GrowingModel& model, int photograph);

    /// The model as it was, when nothing else has changed since.
    void restore(GrowingModel& model) const;

 private:
    struct TrackBefore {
        std::size_t index = 0;
        GrowingTrack track;
    };

    std::size_t photograph_;
    Camera lens_;
    std::vector<Rigid3> cam_from_world_;
    std::vector<TrackBefore> tracks_;
    char is_placed_;
};

}  // namespace lumi
