#include "calib/doctor/diagnosis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "calib/doctor/cohesion.h"
#include "calib/doctor/picture_trouble.h"
#include "calib/work/counted.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr double kMostShare = 0.7;  ///< "Most" of the pairs or photographs.
constexpr double kNearlyAll = 0.9;
constexpr double kFewShare = 0.3;  ///< "Few" of the photographs.

Severity severity_of(const Cohesion& cohesion) {
    if (!cohesion.is_usable()) return Severity::kHopeless;
    return cohesion.is_whole() ? Severity::kNote : Severity::kRisk;
}

/// How bad it is that the named photographs are as they are: a few can be why they themselves are
/// lost, and not why the others do not hang together.
Severity severity_of_few(const CaptureEvidence& evidence, const Cohesion& cohesion,
                         const std::vector<std::string>& names) {
    std::vector<char> is_kept;
    for (const PhotographQuality& photograph : evidence.photographs) {
        is_kept.push_back(std::find(names.begin(), names.end(), photograph.name) == names.end());
    }
    const Cohesion others = cohesion_of(part_of(match_graph_of(evidence), is_kept));
    const bool are_few = static_cast<double>(names.size()) <
                         kFewShare * static_cast<double>(evidence.photographs.size());
    const Severity severity = severity_of(cohesion);
    return are_few && severity_of(others) >= severity ? Severity::kNote : severity;
}

void judge_pictures(const CaptureEvidence& evidence, const Cohesion& cohesion,
                    std::vector<Finding>& findings) {
    std::map<CaptureReason, std::vector<std::string>> concerned;
    for (const PhotographQuality& quality : evidence.photographs) {
        const auto trouble = trouble_with(quality);
        if (trouble) concerned[*trouble].push_back(quality.name);
    }
    for (const auto& [reason, names] : concerned) {
        const double share =
            static_cast<double>(names.size()) / static_cast<double>(evidence.photographs.size());
        Severity severity = share < kFewShare ? Severity::kNote : severity_of(cohesion);
        // What motion looks like in poor pictures says more about the pictures.
        if (share >= kMostShare && evidence.motion.rotation_share() >= kMostShare) {
            severity = Severity::kHopeless;
        }
        findings.push_back(
            {reason, severity, picture_trouble_text(reason, evidence, names.size()), names});
    }
}

void judge_brightness(const CaptureEvidence& evidence, const Cohesion& cohesion,
                      std::vector<Finding>& findings) {
    constexpr double kMaxStops = 2.0;
    std::vector<double> stops;
    for (const PhotographQuality& quality : evidence.photographs) {
        stops.push_back(std::log2(std::max(quality.mean_linear, 1e-4)));
    }
    const double middle = median_of(stops);
    std::vector<std::string> names;
    double farthest = 0;
    for (std::size_t index = 0; index < stops.size(); ++index) {
        const double off = std::abs(stops[index] - middle);
        farthest = std::max(farthest, off);
        if (off > kMaxStops) names.push_back(evidence.photographs[index].name);
    }
    if (names.empty()) return;
    findings.push_back(
        {CaptureReason::kExposure, severity_of_few(evidence, cohesion, names),
         formatted("brightness jumps by up to %.1f stops between photographs", farthest),
         std::move(names)});
}

void judge_motion(const CaptureEvidence& evidence, std::vector<Finding>& findings) {
    const MotionEvidence& motion = evidence.motion;
    if (motion.pairs == 0) return;
    // A pair or two among many photographs are an accident.
    const int min_pairs = static_cast<int>(evidence.photographs.size()) / 2;
    const bool only_turned = motion.only_turned();
    if (motion.rotation_share() >= kMostShare && motion.pairs >= min_pairs) {
        // Sideways before a wall looks much the same: only where hardly a pair says otherwise, no
        // parallax can be hoped for.
        findings.push_back(
            {CaptureReason::kNoParallax,
             only_turned ? Severity::kHopeless : Severity::kNote,
             formatted("the camera turned on the spot or hardly moved: %d of %d pairs "
                       "of photographs show the same view without parallax",
                       motion.rotation_pairs, motion.pairs) +
                 turntable_hint(motion),
             {}});
    }
    if (only_turned) {
        return;
    }
    const auto in_view =
        std::count_if(evidence.pairs.begin(), evidence.pairs.end(),
                      [](const PairGeometry& pair) { return pair.epipoles_in_view; });
    const double forward_share =
        static_cast<double>(in_view) / static_cast<double>(evidence.pairs.size());
    if (forward_share >= kMostShare) {
        findings.push_back(
            {CaptureReason::kForward,
             Severity::kRisk,
             formatted("the camera moved along its line of sight: %d of %zu pairs of "
                       "photographs show the place of the other camera",
                       static_cast<int>(in_view), evidence.pairs.size()),
             {}});
    }
    // A floor or a wall explains most of many pairs of photographs that are in order: only where
    // hardly a match lies outside of the plane is there nothing else.
    if (motion.planar_share() >= kNearlyAll && median_of(evidence.inlier_shares) >= kNearlyAll) {
        // One lens and several sides are enough to tell its focal length even so.
        findings.push_back(
            {CaptureReason::kPlanar,
             Severity::kNote,
             formatted("the photographs show a flat surface: one plane explains %d of "
                       "%d pairs",
                       motion.planar_pairs, motion.pairs),
             {}});
    }
}

void judge_clutter(const CaptureEvidence& evidence, const Cohesion& cohesion,
                   std::vector<Finding>& findings) {
    constexpr double kMinInlierShare = 0.4;
    if (evidence.inlier_shares.empty() ||
        evidence.inlier_shares.size() + 1 < evidence.photographs.size()) {
        return;
    }
    const double share = median_of(evidence.inlier_shares);
    if (share >= kMinInlierShare) return;
    findings.push_back(
        {CaptureReason::kClutter,
         cohesion.is_usable() ? Severity::kRisk : Severity::kHopeless,
         formatted("only %.0f %% of what looks alike in two photographs stands still "
                   "between them",
                   100 * share),
         {}});
}

void judge_cohesion(const CaptureEvidence& evidence, const Cohesion& cohesion,
                    std::vector<Finding>& findings) {
    if (cohesion.is_whole()) return;
    std::vector<std::string> names;
    for (std::size_t group = 1; group < cohesion.groups.size(); ++group) {
        for (const int index : cohesion.groups[group]) {
            names.push_back(evidence.photographs[static_cast<std::size_t>(index)].name);
        }
    }
    if (evidence.pairs.empty()) {
        findings.push_back({CaptureReason::kNoPair,
                            Severity::kHopeless,
                            "no two photographs show the same things",
                            {}});
        return;
    }
    findings.push_back({CaptureReason::kSplit,
                        cohesion.is_usable() ? Severity::kRisk : Severity::kHopeless,
                        formatted("the photographs fall into %zu groups that share nothing; the "
                                  "largest has %zu of %zu",
                                  cohesion.groups.size(), cohesion.groups.front().size(),
                                  evidence.photographs.size()),
                        std::move(names)});
}

/// Two tell poses only through lenses that are known.
bool are_too_few(const CaptureEvidence& evidence) {
    const auto count = static_cast<int>(evidence.photographs.size());
    return count < evidence.min_photographs || (count == 2 && !evidence.focal_lengths_are_known);
}

void judge_count(const CaptureEvidence& evidence, std::vector<Finding>& findings) {
    if (!are_too_few(evidence)) return;
    const std::size_t count = evidence.photographs.size();
    const bool are_accepted = static_cast<int>(count) >= evidence.min_photographs;
    findings.push_back(
        {CaptureReason::kFew,
         Severity::kHopeless,
         are_accepted
             ? "two photographs alone do not tell how far a lens of unknown focal length "
               "turned and moved: a third would, or the lens ([calibration])"
             : "a build ends with E-INGEST-TOOFEW: " + counted(count, "usable photograph") +
                   ", expected at least " + std::to_string(evidence.min_photographs) +
                   (evidence.min_photographs > 2 ? " ([capture] min_photographs)" : ""),
         {}});
}

void judge_duplicates(const CaptureEvidence& evidence, std::vector<Finding>& findings) {
    const auto kept = static_cast<int>(evidence.photographs.size());
    if (evidence.duplicates_left_out == 0) return;
    Severity severity = Severity::kNote;
    if (evidence.duplicates_left_out > kept) severity = Severity::kRisk;
    if (are_too_few(evidence)) severity = Severity::kHopeless;
    findings.push_back({CaptureReason::kDuplicates,
                        severity,
                        counted(evidence.duplicates_left_out, "photograph") +
                            (evidence.duplicates_left_out == 1 ? " repeats" : " repeat") +
                            " another one; " + counted(kept, "different one") +
                            (kept == 1 ? " is left" : " are left"),
                        {}});
}

void judge_loops(const CaptureEvidence& evidence, std::vector<Finding>& findings) {
    constexpr double kMaxConflictShare = 0.15;
    constexpr int kMinLoops = 100;
    const MatchLoops& loops = evidence.loops;
    if (loops.closed + loops.conflicts < kMinLoops) return;
    if (loops.conflict_share() <= kMaxConflictShare) return;
    findings.push_back(
        {CaptureReason::kRepeated,
         Severity::kRisk,
         formatted("things that look alike are taken for one another: %.0f %% of the "
                   "features that are followed through three photographs come back "
                   "elsewhere",
                   100 * loops.conflict_share()),
         {}});
}

/// Causes before their effects: a photograph without features has no pair.
int rank_of(CaptureReason reason) {
    constexpr std::array kOrder{
        CaptureReason::kExposure, CaptureReason::kNoise,      CaptureReason::kTexture,
        CaptureReason::kBlur,     CaptureReason::kDuplicates, CaptureReason::kNoParallax,
        CaptureReason::kRepeated, CaptureReason::kClutter,    CaptureReason::kForward,
        CaptureReason::kPlanar,   CaptureReason::kSplit,      CaptureReason::kNoPair};
    return static_cast<int>(std::find(kOrder.begin(), kOrder.end(), reason) - kOrder.begin());
}

}  // namespace

MatchGraph match_graph_of(const CaptureEvidence& evidence) {
    MatchGraph graph{static_cast<int>(evidence.photographs.size()), {}};
    for (const PairGeometry& pair : evidence.pairs) {
        graph.pairs.emplace_back(pair.pair.first, pair.pair.second);
    }
    return graph;
}

double median_angle_deg(const CaptureEvidence& evidence) {
    std::vector<double> angles;
    for (const PairGeometry& pair : evidence.pairs) angles.push_back(pair.median_angle_deg);
    return median_of(std::move(angles));
}

std::vector<Finding> diagnose(const CaptureEvidence& evidence) {
    std::vector<Finding> findings;
    judge_duplicates(evidence, findings);
    judge_count(evidence, findings);
    if (!evidence.photographs.empty()) {
        const Cohesion cohesion = cohesion_of(match_graph_of(evidence));
        judge_pictures(evidence, cohesion, findings);
        judge_brightness(evidence, cohesion, findings);
        judge_motion(evidence, findings);
        judge_loops(evidence, findings);
        judge_clutter(evidence, cohesion, findings);
        judge_cohesion(evidence, cohesion, findings);
    }
    std::stable_sort(findings.begin(), findings.end(), [](const Finding& a, const Finding& b) {
        if (a.severity != b.severity) return a.severity > b.severity;
        return rank_of(a.reason) < rank_of(b.reason);
    });
    return findings;
}

}  // namespace lumi
