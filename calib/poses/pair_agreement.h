#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/colmap/colmap_database.h"
#include "calib/ingest/ingest.h"
#include "calib/work/progress.h"

namespace lumi {

/// How far a finished model and the pairs it was made from agree.
struct PairAgreement {
    int pairs = 0;         ///< Verified pairs, both of whose photographs were placed.
    int contradicted = 0;  ///< Of these, such whose matches the model denies.
    int outweighed = 0;    ///< Denied as well, but by far more matches: in none of the others.
    int in_order = 0;      ///< Pairs of photographs that follow each other (places_in_order).
    /// Of these, such of whose matches the model denies a fifth and more, and which tell that what
    /// they see was seen from another side altogether. (Weak pairs of noisy photographs are denied
    /// as much by true models, and tell of the same side.)
    int doubtful_in_order = 0;
    /// Of all these pairs, or of their matches, whichever is more: those that are denied.
    double contradicted_share = 0.0;
    /// Of the matches in these pairs: those that lie where the model says they should.
    double agreeing_share = 1.0;
    /// Of the contradicted and the doubtful pairs: the median angle between the rotation that their
    /// own matches tell and the model's. What was taken for another thing is seen from another side
    /// altogether; pictures that are bent, or lenses that differ, turn a pair by a few degrees.
    double contradicted_turn_deg = 0.0;

    /// True when more is denied than chance lets pass.
    [[nodiscard]] bool is_contradiction() const;
    /// True when some of what is denied is seen from another side altogether.
    [[nodiscard]] bool is_mistaken() const;
};

/// A verified pair whose photographs were both placed, and what a model says of it.
struct JudgedPair {
    std::size_t index = 0;  ///< Of the pair, among all.
    std::size_t matches = 0;
    std::size_t agreeing = 0;  ///< Of these, near the epipolar lines of the model.
    /// Along the widest chain of pairs that are not denied (PairTies::between).
    std::size_t tied = 0;

    /// True when most of its matches are farther from these lines than they may be in verification.
    [[nodiscard]] bool is_denied() const { return 2 * agreeing < matches; }
    /// True when so many of them lie there that the pair and the model tell of the same places.
    [[nodiscard]] bool is_agreeing() const { return 5 * agreeing >= 4 * matches; }
};

/// What a model says of the pairs it was made from, in their order; those with too few matches to
/// say anything are left out. `photographs` and `features` are by index. Throws Error:
/// E-INTERRUPTED.
[[nodiscard]] std::vector<JudgedPair> judge_pairs(const Capture& capture,
                                                  const std::vector<Photograph>& photographs,
                                                  const std::vector<ColmapPhotograph>& features,
                                                  const std::vector<VerifiedPair>& pairs,
                                                  const Progress& progress);

/// A pair was verified because many of its matches agree with one motion of the camera. Where the
/// model says another motion, one of the two is wrong: things that look alike were taken for one
/// another. A pair counts as denied when most of its matches are farther from the epipolar lines of
/// the model than they may be in verification; of two cameras at one place, which have no such
/// lines, farther from where the turn between them has them.
///
/// Windows of one house look alike from far aside, where little else is matched. What so few
/// matches say is outweighed where a chain of pairs that agree leads from one photograph to the
/// other, each with two and a half times as many. Models that took sides of a house for one another
/// are not saved by it: the pairs that they deny see the same things. Throws Error: E-INTERRUPTED.
[[nodiscard]] PairAgreement compare_with_pairs(const Capture& capture,
                                               const std::vector<Photograph>& photographs,
                                               const std::vector<ColmapPhotograph>& features,
                                               const std::vector<VerifiedPair>& pairs,
                                               const Progress& progress);

}  // namespace lumi
