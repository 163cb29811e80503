#include "calib/features/pair_selection.h"

#include <algorithm>
#include <span>

#include "calib/features/descriptor_matching.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

std::span<const Descriptor> largest(const Features& features, int count) {
    const std::span<const Descriptor> all(features.descriptors);
    return all.first(std::min(all.size(), static_cast<std::size_t>(count)));
}

}  // namespace

std::vector<std::pair<int, int>> select_pairs(const std::vector<Features>& photographs,
                                              const PairSelectionOptions& options, int threads,
                                              Progress& progress) {
    const int count = static_cast<int>(photographs.size());
    std::vector<std::pair<int, int>> pairs;
    for (int first = 0; first < count; ++first) {
        for (int second = first + 1; second < count; ++second) pairs.emplace_back(first, second);
    }
    if (count <= options.exhaustive_up_to) return pairs;

    progress.begin("looking for photographs that overlap", pairs.size());
    std::vector<char> is_kept(pairs.size(), 0);
    parallel_for(static_cast<int>(pairs.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto [first, second] = pairs[static_cast<std::size_t>(index)];
        const auto preview = [&](int photograph) {
            return largest(photographs[static_cast<std::size_t>(photograph)],
                           options.preview_features);
        };
        const bool follows = second - first <= options.neighbours;
        const auto matches = static_cast<std::size_t>(options.min_preview_matches);
        is_kept[static_cast<std::size_t>(index)] =
            follows || match_descriptors(preview(first), preview(second), {}).size() >= matches;
        progress.advance();
    });
    std::vector<std::pair<int, int>> kept;
    for (std::size_t index = 0; index < pairs.size(); ++index) {
        if (is_kept[index] != 0) kept.push_back(pairs[index]);
    }
    return kept;
}

}  // namespace lumi
