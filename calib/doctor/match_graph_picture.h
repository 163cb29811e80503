#pragma once

#include <string>

#include "calib/doctor/diagnosis.h"

namespace lumi {

/// The match graph as one SVG document: photographs around a circle in the order of their names, a
/// line for each pair that agrees with one motion of the camera (the more matches, the thicker;
/// blue: with parallax, orange: explained by a plane or by a turn on the spot), groups in colours
/// of their own, and photographs whose loss would part a group ringed.
[[nodiscard]] std::string match_graph_svg(const CaptureEvidence& evidence);

}  // namespace lumi
