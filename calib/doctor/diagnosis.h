#pragma once

#include <string>
#include <vector>

#include "calib/doctor/capture_reason.h"
#include "calib/doctor/match_graph.h"
#include "calib/doctor/match_loops.h"
#include "calib/doctor/photograph_quality.h"
#include "calib/matching/pair_geometry.h"
#include "calib/matching/rotation_check.h"

namespace lumi {

/// What was seen of a capture before any pose is known.
struct CaptureEvidence {
    std::vector<PhotographQuality> photographs;
    int duplicates_left_out = 0;        ///< Photographs that were taken twice from one place.
    int width_px = 0;                   ///< The longer side of the pictures that were looked at.
    std::vector<PairGeometry> pairs;    ///< Those that agree with one motion of the camera.
    std::vector<double> inlier_shares;  ///< Of all pairs with enough matches to tell.
    MatchLoops loops;
    MotionEvidence motion;
    int min_photographs = 2;               ///< A build ends with fewer. >= 2.
    bool focal_lengths_are_known = false;  ///< Of every photograph, if only roughly (EXIF).
};

/// The pairs as a graph.
[[nodiscard]] MatchGraph match_graph_of(const CaptureEvidence& evidence);

/// At which rays to the same point meet in the middle pair; 0 without pairs.
[[nodiscard]] double median_angle_deg(const CaptureEvidence& evidence);

enum class Severity {
    kNote,      ///< Worth knowing; poses will come out.
    kRisk,      ///< Photographs will be lost, or poses be poor.
    kHopeless,  ///< No poses can be expected.
};

/// Something that stands between these photographs and good poses.
struct Finding {
    CaptureReason reason = CaptureReason::kNoPair;
    Severity severity = Severity::kNote;
    std::string what;                      ///< In the words of a photographer, with figures.
    std::vector<std::string> photographs;  ///< Those concerned; empty: all.
};

/// What the evidence says, the worst first. The match graph decides whether something hurts; the
/// pictures and the motion decide why.
[[nodiscard]] std::vector<Finding> diagnose(const CaptureEvidence& evidence);

}  // namespace lumi
