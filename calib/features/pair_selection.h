#pragma once

#include <utility>
#include <vector>

#include "calib/features/features.h"
#include "calib/work/progress.h"

namespace lumi {

struct PairSelectionOptions {
    int exhaustive_up_to = 40;    ///< Photographs: so many are all compared with one another. >= 2.
    int neighbours = 3;           ///< Photographs that follow by name are always compared. >= 1.
    int most_similar = 20;        ///< Photographs that look most alike as a whole. >= 0.
    int preview_features = 600;   ///< The largest features, compared first. > 0.
    int min_preview_matches = 4;  ///< Fewer than this between the largest: not worth the rest. > 0.
};

/// Pairs (first < second, ascending) of photographs that may show the same things.
///
/// A small set is compared exhaustively. In a larger one, each photograph is compared with those
/// that follow it by name, with those 4, 8, 16, ... further on (a camera that comes back), and with
/// those that look most like it (see photograph_similarity); of these, only the ones that follow
/// are kept unseen, the others when their largest features match, a few per cent of the work
/// ("preemptive feature matching", Wu, Towards linear-time incremental structure from motion, 3DV
/// 2013, section 3).
[[nodiscard]] std::vector<std::pair<int, int>> select_pairs(
    const std::vector<Features>& photographs, const PairSelectionOptions& options, int threads,
    Progress& progress);

}  // namespace lumi
