#include "calib/matching/photograph_matching.h"

#include "calib/capture/gray.h"
#include "calib/features/descriptor_matching.h"
#include "calib/features/pair_selection.h"
#include "calib/pictures/drawn_mask.h"
#include "calib/pictures/image_io.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

/// Verification asks for 15 inliers. Of real pairs with 15 to 19 matches one in thirty has them.
constexpr std::size_t kMinMatches = 20;

}  // namespace

std::vector<Features> detect_features(const std::vector<Photograph>& photographs,
                                      const std::filesystem::path& mask_folder,
                                      const SiftOptions& options, int threads, Progress& progress) {
    if (!mask_folder.empty()) expect_own_masks(names_of(photographs), mask_folder);
    progress.begin("finding features", photographs.size());
    std::vector<Features> features(photographs.size());
    parallel_for(static_cast<int>(photographs.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto position = static_cast<std::size_t>(index);
        const ColorImage picture = read_color_image(photographs[position].picture_path);
        const GrayImage mask = mask_folder.empty()
                                   ? GrayImage()
                                   : drawn_mask(photographs[position].name, picture.width(),
                                                picture.height(), mask_folder);
        features[position] = detect_sift(gray_of(picture), options, mask);
        progress.advance();
    });
    return features;
}

std::vector<PairMatches> match_photographs(const std::vector<Features>& photographs, int threads,
                                           Progress& progress) {
    return match_pairs(photographs, select_pairs(photographs, {}, threads, progress), {}, threads,
                       progress);
}

std::vector<PairMatches> match_pairs(const std::vector<Features>& photographs,
                                     const std::vector<std::pair<int, int>>& pairs,
                                     const DescriptorMatchingOptions& options, int threads,
                                     Progress& progress) {
    progress.begin("comparing photographs", pairs.size());
    std::vector<PairMatches> matches(pairs.size());
    parallel_for(static_cast<int>(pairs.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto position = static_cast<std::size_t>(index);
        const auto [first, second] = pairs[position];
        matches[position] = {
            first, second,
            match_descriptors(photographs[static_cast<std::size_t>(first)].descriptors,
                              photographs[static_cast<std::size_t>(second)].descriptors, options)};
        progress.advance();
    });
    std::erase_if(matches,
                  [](const PairMatches& pair) { return pair.matches.size() < kMinMatches; });
    return matches;
}

}  // namespace lumi
