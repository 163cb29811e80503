#pragma once

#include <string>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

struct JointCheck {
    Capture mapped;
    /// Not empty: less than half would hang together, and `mapped` is as it was. Unless another
    /// trouble explains that, the capture is to be refused for it.
    std::string trouble;
};

/// Looks at the joints between parts of a mapped capture: every part that a cut through the maximum
/// spanning tree of the views parts from the others, by the points that two views share (Zahn,
/// Graph-theoretical methods for detecting and describing gestalt clusters, IEEE ToC 1971).
///
/// A part that the shared points want clearly elsewhere is put there. A part whose place they do
/// not determine (see PartJoint) is left out, and `job.evidence` warns of it (E-POSES-SPLIT).
/// Throws Error: E-INTERRUPTED.
[[nodiscard]] JointCheck with_firm_joints(const MappingJob& job, const Capture& mapped);

}  // namespace lumi
