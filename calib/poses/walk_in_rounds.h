#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/ingest/ingest.h"

namespace lumi {

/// A walk that, in the order of taking, passes the same places again and again.
struct WalkInRounds {
    int places = 0;
    int rounds = 0;  ///< Begun ones.
    /// Nine in ten of the places are met again as closely, as a share of the median step.
    double missed_share = 0.0;

    [[nodiscard]] std::string text() const;
};

/// Where all sides of a thing look alike and the steps around it divide a side evenly, photographs
/// of other sides are the same photographs: a model that takes the sides for one another
/// contradicts none of its pairs and leaves no residual. What gives it away is the walk that it
/// tells of. Every round meets the places of the one before, more closely than a hand does, and
/// then leaps back to the first place, where one who really walks around arrives by a step like the
/// others. Empty for any other walk: once around or several times, to and fro, row by row; and
/// where rounds lie side by side (by the same in the cameras' axes: two lenses of a rig, rows of
/// another height) or look by the same beside each other (a slider that goes its way again,
/// tilted), or are of different cameras, by what the files say or as their names do not count on
/// (L_1, L_2, R_1, R_2). Photographs may be missing, in the model or altogether, as long as they
/// take away no more than a third of the meetings, or one in ten misplaced. `photographs` are all
/// that were taken, for their order.
[[nodiscard]] std::optional<WalkInRounds> walk_in_rounds(
    const Capture& model, const std::vector<Photograph>& photographs);

}  // namespace lumi
