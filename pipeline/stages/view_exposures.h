#pragma once

#include <map>
#include <set>
#include <string>

#include "calib/work/progress.h"
#include "meshing/exposure/exposure_gains.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// How the photographs of a capture differ in exposure, whichever of them a package keeps.
struct ViewExposures {
    ExposureGains found;
    /// By name: what brings each photograph into one exposure with all; empty where they do not
    /// differ.
    std::map<std::string, ExposureGain> gain_of_view;
    /// Those whose gain tells nothing of it (ExposureGains::tell_white_balance).
    std::set<std::string> without_white_balance;
};

/// Measures how photographs darken towards their corners, which the Lumigraph takes, and differ in
/// exposure.
[[nodiscard]] ViewExposures find_exposures(Lumigraph& lumigraph, int threads, Progress& progress);

/// Gives each view the gain that brings it into the exposure of those around it
/// (gains_among_neighbours): to be done again whenever views are left out, since nothing is to be
/// met that is not there.
void even_among_neighbours(const ViewExposures& exposures, Lumigraph& lumigraph);

}  // namespace lumi
