#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/colmap/colmap_database.h"
#include "calib/ingest/ingest.h"

namespace lumi {

/// How far a finished model and the pairs it was made from agree.
struct PairAgreement {
    int pairs = 0;         ///< Verified pairs, both of whose photographs were placed.
    int contradicted = 0;  ///< Of these, such whose matches the model denies.
    int outweighed = 0;    ///< Denied as well, but by far more matches: in none of the others.
    /// Of all these pairs, or of their matches, whichever is more: those that are denied.
    double contradicted_share = 0.0;
    /// Of the matches in these pairs: those that lie where the model says they should.
    double agreeing_share = 1.0;
    /// Of the contradicted pairs: the median angle between the rotation that their own matches tell
    /// and the model's. What was taken for another thing is seen from another side altogether;
    /// pictures that are bent, or lenses that differ, turn a pair by a few degrees.
    double contradicted_turn_deg = 0.0;

    /// True when more is denied than chance lets pass.
    [[nodiscard]] bool is_contradiction() const;
    /// True when some of what is denied is seen from another side altogether.
    [[nodiscard]] bool is_mistaken() const;
};

/// A pair was verified because many of its matches agree with one motion of the camera. Where the
/// model says another motion, one of the two is wrong: things that look alike were taken for one
/// another. A pair counts as denied when most of its matches are farther from the epipolar lines of
/// the model than they may be in verification.
///
/// Windows of one house look alike from far aside, where little else is matched. What so few
/// matches say is outweighed where a chain of pairs that agree leads from one photograph to the
/// other, each with two and a half times as many. Models that took sides of a house for one another
/// are not saved by it: the pairs that they deny see the same things.
[[nodiscard]] PairAgreement compare_with_pairs(const Capture& capture,
                                               const std::vector<Photograph>& photographs,
                                               const std::vector<ColmapPhotograph>& features,
                                               const std::vector<VerifiedPair>& pairs);

}  // namespace lumi
