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
    /// Of all these pairs, or of their matches, whichever is more: those that are denied.
    double contradicted_share = 0.0;
};

/// A pair was verified because many of its matches agree with one motion of the camera. Where the
/// model says another motion, one of the two is wrong: things that look alike were taken for one
/// another. A pair counts as denied when most of its matches are farther from the epipolar lines of
/// the model than they may be in verification.
[[nodiscard]] PairAgreement compare_with_pairs(const Capture& capture,
                                               const std::vector<Photograph>& photographs,
                                               const std::vector<ColmapPhotograph>& features,
                                               const std::vector<VerifiedPair>& pairs);

}  // namespace lumi
