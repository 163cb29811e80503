#include "calib/poses/incremental_mapping.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "calib/features/photograph_similarity.h"
#include "calib/mapping/incremental_mapper.h"
#include "calib/matching/pair_verification.h"
#include "calib/matching/photograph_matching.h"
#include "calib/poses/verified_matching.h"

namespace lumi {
namespace {

/// The attempts, from strict to lenient.
struct Attempt {
    const char* description;
    int min_inliers;
    double min_inlier_share;
};
constexpr Attempt kStrict{"our own mapper", 30, 0.25};
constexpr Attempt kLenient{"our own mapper, fewer matches to add a photograph", 15, 0.15};
constexpr Attempt kBridged{"our own mapper, with lenient matches to the missing photographs", 15,
                           0.15};

IncrementalMappingOptions mapping_options(const MappingJob& job, const Attempt& attempt) {
    IncrementalMappingOptions options;
    options.refine_lenses = job.refine_lens;
    options.min_inliers = attempt.min_inliers;
    options.min_inlier_share = attempt.min_inlier_share;
    for (const ColmapCamera& camera : job.groups.cameras) {
        options.focal_length_is_guessed.push_back(camera.focal_length_is_known ? 0 : 1);
    }
    return options;
}

bool is_complete(const GrowingModel& model) {
    return model.placed() == static_cast<int>(model.pixels.size());
}

/// Tells of each photograph as it is placed, and adds to the model until nothing can be added.
void grow(const MappingJob& job, GrowingModel& model, const Attempt& attempt) {
    const int placed_before = model.placed();
    grow_model(
        model, mapping_options(job, attempt), [&](int) { job.progress.advance(); }, job.progress);
    if (model.placed() > placed_before) job.evidence.start = attempt.description;
}

/// Strict first; what is still missing then is asked for less.
GrowingModel mapped(const MappingJob& job, const MatchedPhotographs& matched) {
    GrowingModel model = unplaced_model(job.groups.cameras, matched.photographs, matched.pairs);
    job.progress.begin("placing photographs", job.photographs.size());
    map_from_start(
        model, matched.pairs, mapping_options(job, kStrict), [&](int) { job.progress.advance(); },
        job.progress);
    job.evidence.start = kStrict.description;
    if (model.placed() > 0 && !is_complete(model)) grow(job, model, kLenient);
    return model;
}

/// Each missing photograph with the placed ones that look most like it.
std::vector<std::pair<int, int>> bridging_pairs(const MatchedPhotographs& matched,
                                                const GrowingModel& model) {
    constexpr std::size_t kMostSimilar = 10;
    const Eigen::MatrixXf similarity = photograph_similarity(matched.features, {});
    std::vector<std::pair<int, int>> pairs;
    for (int missing = 0; missing < static_cast<int>(model.is_placed.size()); ++missing) {
        if (model.is_placed[static_cast<std::size_t>(missing)] != 0) continue;
        std::vector<int> placed;
        for (int other = 0; other < static_cast<int>(model.is_placed.size()); ++other) {
            if (model.is_placed[static_cast<std::size_t>(other)] != 0) placed.push_back(other);
        }
        std::stable_sort(placed.begin(), placed.end(), [&](int a, int b) {
            return similarity(a, missing) > similarity(b, missing);
        });
        if (placed.size() > kMostSimilar) placed.resize(kMostSimilar);
        for (const int other : placed) pairs.push_back(std::minmax(missing, other));
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// Replaces pairs by those with more inliers, and adds the new ones.
void take_in(std::vector<VerifiedPair>& pairs, std::vector<VerifiedPair> others) {
    std::map<std::pair<int, int>, VerifiedPair> by_photographs;
    for (VerifiedPair& pair : pairs) {
        by_photographs[{pair.first, pair.second}] = std::move(pair);
    }
    for (VerifiedPair& other : others) {
        VerifiedPair& pair = by_photographs[{other.first, other.second}];
        if (other.inliers.size() > pair.inliers.size()) pair = std::move(other);
    }
    pairs.clear();
    for (auto& [photographs, pair] : by_photographs) pairs.push_back(std::move(pair));
}

/// The model's cameras and poses with the tracks of more pairs.
GrowingModel with_pairs(const MappingJob& job, const MatchedPhotographs& matched,
                        const GrowingModel& model) {
    GrowingModel result = unplaced_model(job.groups.cameras, matched.photographs, matched.pairs);
    result.cameras = model.cameras;
    result.is_placed = model.is_placed;
    result.cam_from_world = model.cam_from_world;
    update_rays(result);
    triangulate_all_tracks(result, {});
    return result;
}

/// Looks for what connects the missing photographs with the placed ones among more doubtful
/// matches: the geometry decides which of them are right.
void bridge(const MappingJob& job, MatchedPhotographs& matched, GrowingModel& model) {
    const std::vector<PairMatches> matches =
        match_pairs(matched.features, bridging_pairs(matched, model), kLenientMatching, job.threads,
                    job.progress);
    take_in(matched.pairs, verify_pairs(matches, job.groups.cameras, matched.photographs,
                                        job.lens_is_calibrated, {}, job.threads, job.progress));
    job.progress.begin("placing the missing photographs",
                       job.photographs.size() - static_cast<std::size_t>(model.placed()));
    GrowingModel bridged = with_pairs(job, matched, model);
    grow(job, bridged, kBridged);
    if (bridged.placed() > model.placed()) model = std::move(bridged);
}

/// A model of its own among the photographs that could not be placed: the capture is in parts.
void look_for_another_part(const MappingJob& job, const MatchedPhotographs& matched,
                           const GrowingModel& model) {
    std::vector<VerifiedPair> pairs;
    for (const VerifiedPair& pair : matched.pairs) {
        if (model.is_placed[static_cast<std::size_t>(pair.first)] == 0 &&
            model.is_placed[static_cast<std::size_t>(pair.second)] == 0) {
            pairs.push_back(pair);
        }
    }
    GrowingModel part = unplaced_model(job.groups.cameras, matched.photographs, pairs);
    IncrementalMappingOptions options = mapping_options(job, kStrict);
    options.starts = 1;
    map_from_start(
        part, pairs, options, [](int) {}, job.progress);
    constexpr int kWorthTelling = 3;
    if (part.placed() < kWorthTelling) return;
    ++job.evidence.models_found;
    job.evidence.warnings.push_back(
        "the photographs fall into parts that nothing connects: " + std::to_string(model.placed()) +
        " are used; another " + std::to_string(part.placed()) +
        " fit together, but not with these. Photographs between both would join them; if they "
        "show something else, build them alone");
}

GrowingModel placed_as_well_as_possible(const MappingJob& job, MatchedPhotographs& matched) {
    GrowingModel model = mapped(job, matched);
    const bool has_descriptors = !matched.features.empty();
    if (model.placed() >= 2 && !is_complete(model) && has_descriptors) bridge(job, matched, model);
    return model;
}

/// From other matches, which are taken with their model if more photographs are placed by them.
void map_again(const MappingJob& job, MatchedPhotographs others, MatchedPhotographs& matched,
               GrowingModel& model) {
    const std::string start = job.evidence.start;
    GrowingModel again = placed_as_well_as_possible(job, others);
    if (again.placed() > model.placed()) {
        model = std::move(again);
        matched = std::move(others);
        job.evidence.start += ", more features";
    } else {
        job.evidence.start = start;
    }
}

}  // namespace

std::optional<Capture> map_incrementally(const MappingJob& job, MatchedPhotographs& matched) {
    const double total = static_cast<double>(job.photographs.size());
    GrowingModel model = placed_as_well_as_possible(job, matched);
    if (model.placed() < kEnoughPlacedShare * total && !matched.features.empty()) {
        auto detailed =
            match_more_features(job, matched, static_cast<std::size_t>(model.placed()), "detailed");
        if (detailed) map_again(job, std::move(*detailed), matched, model);
    }
    if (model.placed() < 2) return std::nullopt;
    job.evidence.models_found = 1;
    if (!is_complete(model)) look_for_another_part(job, matched, model);
    return capture_of(model, names_of(job.photographs));
}

}  // namespace lumi
