#include "calib/features/pair_selection.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <span>

#include "calib/features/descriptor_matching.h"
#include "calib/features/photograph_similarity.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

std::span<const Descriptor> largest(const Features& features, int count) {
    const std::span<const Descriptor> all(features.descriptors);
    return all.first(std::min(all.size(), static_cast<std::size_t>(count)));
}

Pairs all_pairs(int count) {
    Pairs pairs;
    for (int first = 0; first < count; ++first) {
        for (int second = first + 1; second < count; ++second) pairs.emplace_back(first, second);
    }
    return pairs;
}

/// The `count` photographs most similar to `photograph`, the first of equals first.
std::vector<int> most_similar_to(const Eigen::MatrixXf& similarity, int photograph, int count) {
    std::vector<int> others(static_cast<std::size_t>(similarity.rows()));
    std::iota(others.begin(), others.end(), 0);
    std::erase(others, photograph);
    std::stable_sort(others.begin(), others.end(), [&](int a, int b) {
        return similarity(a, photograph) > similarity(b, photograph);
    });
    if (others.size() > static_cast<std::size_t>(count)) {
        others.resize(static_cast<std::size_t>(count));
    }
    return others;
}

Pairs candidates(const std::vector<Features>& photographs, const PairSelectionOptions& options) {
    const int count = static_cast<int>(photographs.size());
    PhotographSimilarityOptions similarity_options;
    similarity_options.features = options.preview_features;
    const Eigen::MatrixXf similarity = photograph_similarity(photographs, similarity_options);
    std::set<std::pair<int, int>> pairs;
    for (int photograph = 0; photograph < count; ++photograph) {
        const auto add = [&](int other) {
            if (other < count) pairs.insert(std::minmax(photograph, other));
        };
        for (int step = 1; step <= options.neighbours; ++step) add(photograph + step);
        for (int step = 4; step < count; step *= 2) add(photograph + step);
        for (const int other : most_similar_to(similarity, photograph, options.most_similar)) {
            add(other);
        }
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace

Pairs select_pairs(const std::vector<Features>& photographs, const PairSelectionOptions& options,
                   int threads, Progress& progress) {
    const int count = static_cast<int>(photographs.size());
    if (count <= options.exhaustive_up_to) return all_pairs(count);
    const Pairs pairs = candidates(photographs, options);
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
    Pairs kept;
    for (std::size_t index = 0; index < pairs.size(); ++index) {
        if (is_kept[index] != 0) kept.push_back(pairs[index]);
    }
    return kept;
}

}  // namespace lumi
