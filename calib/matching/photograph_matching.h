#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "calib/colmap/match_list.h"
#include "calib/features/descriptor_matching.h"
#include "calib/features/features.h"
#include "calib/features/sift.h"
#include "calib/ingest/ingest.h"
#include "calib/work/progress.h"

namespace lumi {

/// The features of every photograph's working copy, in their order; where a folder of masks is
/// given (see drawn_mask), those of what they show alone. Throws Error (E-MASK-...).
[[nodiscard]] std::vector<Features> detect_features(const std::vector<Photograph>& photographs,
                                                    const std::filesystem::path& mask_folder,
                                                    const SiftOptions& options, int threads,
                                                    Progress& progress);

/// Matches by look alone between the pairs worth comparing; pairs with too few for a geometry to
/// be verified are left out. Ascending.
[[nodiscard]] std::vector<PairMatches> match_photographs(const std::vector<Features>& photographs,
                                                         int threads, Progress& progress);

/// The same between given pairs.
[[nodiscard]] std::vector<PairMatches> match_pairs(const std::vector<Features>& photographs,
                                                   const std::vector<std::pair<int, int>>& pairs,
                                                   const DescriptorMatchingOptions& options,
                                                   int threads, Progress& progress);

}  // namespace lumi
