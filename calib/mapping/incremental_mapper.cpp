#include "calib/mapping/incremental_mapper.h"

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

#include "calib/lens/lens_form.h"
#include "calib/mapping/before_placement.h"
#include "calib/mapping/model_adjustment.h"
#include "calib/mapping/resection.h"
#include "calib/mapping/two_view_start.h"
#include "calib/mapping/visibility_score.h"

namespace lumi {
namespace {

/// A pose, with the lens under which it was found.
struct Placement {
    Resection resection;
    Camera lens;
};

class Growth {
 public:
    Growth(GrowingModel& model, const IncrementalMappingOptions& options,
           const std::function<void(int)>& on_placed, Progress& progress)
        : model_(model),
          options_(options),
          on_placed_(on_placed),
          progress_(progress),
          points_when_it_failed_(model.pixels.size(), 0),
          placed_at_last_adjustment_(model.placed()) {
        triangulation_.max_error_px = options.max_error_px;
    }

    void grow() {
        int most_placed = 0;
        do {
            while (place_next()) {
                const bool is_small = model_.placed() <= 4;
                if (is_small || model_.placed() >= 1.2 * placed_at_last_adjustment_) adjust_all();
            }
            adjust_all();
            if (model_.placed() <= most_placed) return;
            most_placed = model_.placed();
            // Better cameras and more points: whoever failed may try again.
            std::fill(points_when_it_failed_.begin(), points_when_it_failed_.end(), 0);
        } while (place_next());
    }

    void adjust_all() {
        constexpr int kLensNeeds = 3;  // Photographs: two say too little of a focal length.
        ModelAdjustmentOptions adjustment;
        adjustment.refine_lenses = options_.refine_lenses && model_.placed() >= kLensNeeds;
        adjust_model(model_, adjustment, progress_);
        judge_points(model_, triangulation_);
        triangulate_all_tracks(model_, triangulation_);
        drop_lost_photographs();
        placed_at_last_adjustment_ = model_.placed();
    }

 private:
    struct Candidate {
        int photograph = 0;
        double score = 0;
        int points = 0;
    };

    /// The photographs that may be placed, the one that sees most first.
    [[nodiscard]] std::vector<Candidate> candidates() const {
        std::vector<Candidate> result;
        for (std::size_t index = 0; index < model_.pixels.size(); ++index) {
            if (model_.is_placed[index] != 0) continue;
            const SeenPoints seen = seen_points(model_, static_cast<int>(index));
            const int points = static_cast<int>(seen.tracks.size());
            // One that failed gets another chance when it sees clearly more.
            if (points < options_.min_inliers || points < 1.2 * points_when_it_failed_[index] + 1) {
                continue;
            }
            result.push_back(
                {static_cast<int>(index),
                 visibility_score(model_.camera_of(static_cast<int>(index)), seen.pixels), points});
        }
        std::stable_sort(result.begin(), result.end(),
                         [](const auto& a, const auto& b) { return a.score > b.score; });
        return result;
    }

    bool place_next() {
        for (const Candidate& candidate : candidates()) {
            progress_.throw_if_interrupted();
            const auto position = static_cast<std::size_t>(candidate.photograph);
            if (place(candidate.photograph)) {
                points_when_it_failed_[position] = 0;
                on_placed_(candidate.photograph);
                return true;
            }
            points_when_it_failed_[position] = candidate.points;
        }
        return false;
    }

    bool place(int photograph) {
        const SeenPoints seen = seen_points(model_, photograph);
        const auto placement = placement_of(photograph, seen);
        if (!placement) return false;
        const BeforePlacement before(model_, photograph);
        const auto position = static_cast<std::size_t>(photograph);
        const auto camera = static_cast<std::size_t>(model_.camera_of_photograph[position]);
        if (!(model_.cameras[camera] == placement->lens)) {
            model_.cameras[camera] = placement->lens;
            update_rays(model_);
        }
        model_.is_placed[position] = 1;
        model_.cam_from_world[position] = placement->resection.cam_from_world;
        const std::vector<std::size_t> tracks = tracks_of(model_, photograph);
        triangulate_tracks(model_, tracks, triangulation_);
        ModelAdjustmentOptions adjustment;
        adjustment.max_iterations = 10;
        adjust_around(model_, photograph, adjustment, progress_);
        triangulate_tracks(model_, tracks, triangulation_);
        if (inliers_of(photograph) >= options_.min_inliers) return true;
        before.restore(model_);
        return false;
    }

    [[nodiscard]] std::optional<Placement> placement_of(int photograph,
                                                        const SeenPoints& seen) const {
        const Camera& lens = model_.camera_of(photograph);
        std::optional<Placement> best;
        for (const double factor : focal_length_factors(photograph)) {
            std::vector<Eigen::Vector2d> rays = seen.rays;
            const Camera tried = with_focal_length_scaled(lens, factor);
            if (factor != 1.0) {
                for (std::size_t index = 0; index < rays.size(); ++index) {
                    rays[index] = unproject(tried, seen.pixels[index]).head<2>();
                }
            }
            auto found = resect(seen.points_in_world, rays, focal_length_px(tried).mean(), {});
            if (found && (!best || found->inliers > best->resection.inliers)) {
                best = Placement{std::move(*found), tried};
            }
        }
        if (!best || best->resection.inliers < options_.min_inliers ||
            best->resection.inliers <
                options_.min_inlier_share * static_cast<double>(seen.tracks.size())) {
            return std::nullopt;
        }
        return best;
    }

    /// Other focal lengths are tried for a lens that nothing is known of and nobody has used yet.
    [[nodiscard]] std::vector<double> focal_length_factors(int photograph) const {
        const int camera = model_.camera_of_photograph[static_cast<std::size_t>(photograph)];
        const auto position = static_cast<std::size_t>(camera);
        bool is_used = false;
        for (std::size_t index = 0; index < model_.is_placed.size(); ++index) {
            is_used = is_used || (model_.is_placed[index] != 0 &&
                                  model_.camera_of_photograph[index] == camera);
        }
        const bool is_guessed = position < options_.focal_length_is_guessed.size() &&
                                options_.focal_length_is_guessed[position] != 0;
        if (is_used || !is_guessed) return {1.0};
        return {1.0, 0.7, 0.84, 1.2, 1.44, 1.73, 0.58};
    }

    [[nodiscard]] int inliers_of(int photograph) const {
        int inliers = 0;
        for (const std::size_t index : tracks_of(model_, photograph)) {
            const GrowingTrack& track = model_.tracks[index];
            for (std::size_t element = 0; element < track.elements.size(); ++element) {
                if (track.elements[element].photograph == photograph) {
                    inliers += track.is_inlier[element] != 0 ? 1 : 0;
                }
            }
        }
        return inliers;
    }

    void remove(int photograph) {
        model_.is_placed[static_cast<std::size_t>(photograph)] = 0;
        for (const std::size_t index : tracks_of(model_, photograph)) {
            GrowingTrack& track = model_.tracks[index];
            for (std::size_t element = 0; element < track.elements.size(); ++element) {
                if (track.elements[element].photograph == photograph) track.is_inlier[element] = 0;
            }
            if (track.inliers() < 2) track.forget_point();
        }
    }

    /// Photographs that an adjustment has shown to contradict the others.
    void drop_lost_photographs() {
        if (model_.placed() <= 2) return;
        for (std::size_t index = 0; index < model_.is_placed.size(); ++index) {
            const int photograph = static_cast<int>(index);
            if (model_.is_placed[index] == 0 || model_.placed() <= 2) continue;
            const int inliers = inliers_of(photograph);
            if (inliers >= options_.min_inliers / 2) continue;
            points_when_it_failed_[index] =
                static_cast<int>(seen_points(model_, photograph).tracks.size());
            remove(photograph);
        }
    }

    GrowingModel& model_;
    const IncrementalMappingOptions& options_;
    const std::function<void(int)>& on_placed_;
    Progress& progress_;
    TriangulationOptions triangulation_;
    std::vector<int> points_when_it_failed_;
    int placed_at_last_adjustment_;
};

/// Two photographs and what both see; false when that is too little.
bool begin_with(GrowingModel& model, const TwoViewStart& start,
                const IncrementalMappingOptions& options, const TwoViewStartOptions& start_options,
                Progress& progress) {
    const auto first = static_cast<std::size_t>(start.first);
    const auto second = static_cast<std::size_t>(start.second);
    model.is_placed[first] = model.is_placed[second] = 1;
    model.cam_from_world[first] = {};
    model.cam_from_world[second] = start.second_from_first;
    TriangulationOptions triangulation;
    triangulation.max_error_px = options.max_error_px;
    triangulate_tracks(model, tracks_of(model, start.first), triangulation);
    ModelAdjustmentOptions adjustment;
    adjustment.refine_lenses = false;
    adjust_model(model, adjustment, progress);
    judge_points(model, triangulation);
    triangulate_tracks(model, tracks_of(model, start.first), triangulation);
    return model.point_count() >= static_cast<std::size_t>(start_options.min_points) / 2;
}

bool is_better(const GrowingModel& a, const GrowingModel& b) {
    if (a.placed() != b.placed()) return a.placed() > b.placed();
    return a.point_count() > b.point_count();
}

/// Of the starts that lead anywhere, tried one after another; empty where none does.
std::optional<GrowingModel> best_model_of(const GrowingModel& unplaced,
                                          const std::vector<VerifiedPair>& pairs,
                                          const TwoViewStartOptions& start_options,
                                          const IncrementalMappingOptions& options,
                                          const std::function<void(int)>& on_placed,
                                          Progress& progress) {
    constexpr double kNearlyAll = 0.9;
    std::optional<GrowingModel> best;
    int tried = 0;
    std::vector<char> was_placed(unplaced.pixels.size(), 0);
    for (const TwoViewStart& start : two_view_starts(unplaced, pairs, start_options)) {
        // A start that lies within a model that was found before would lead to the same.
        if (was_placed[static_cast<std::size_t>(start.first)] != 0 &&
            was_placed[static_cast<std::size_t>(start.second)] != 0 && tried > 1) {
            continue;
        }
        if (tried == options.starts) break;
        GrowingModel candidate = unplaced;
        if (!begin_with(candidate, start, options, start_options, progress)) continue;
        ++tried;
        grow_model(candidate, options, on_placed, progress);
        for (std::size_t index = 0; index < was_placed.size(); ++index) {
            if (candidate.is_placed[index] != 0) was_placed[index] = 1;
        }
        if (candidate.placed() < 2 || (best && !is_better(candidate, *best))) continue;
        best = std::move(candidate);
        if (best->placed() >= kNearlyAll * static_cast<double>(was_placed.size())) break;
    }
    return best;
}

}  // namespace

void grow_model(GrowingModel& model, const IncrementalMappingOptions& options,
                const std::function<void(int)>& on_placed, Progress& progress) {
    Growth(model, options, on_placed, progress).grow();
}

void map_from_start(GrowingModel& model, const std::vector<VerifiedPair>& pairs,
                    const IncrementalMappingOptions& options,
                    const std::function<void(int)>& on_placed, Progress& progress) {
    if (model.placed() > 0) throw std::invalid_argument("a start for a model that has begun");
    // Little parallax is all there is in a shallow capture.
    constexpr TwoViewStartOptions kShallow{
        .min_angle_rad = 0.035, .full_angle_rad = 0.09, .min_points = 30};
    std::optional<GrowingModel> best;
    for (const TwoViewStartOptions& start_options : {TwoViewStartOptions{}, kShallow}) {
        auto found = best_model_of(model, pairs, start_options, options, on_placed, progress);
        // As few from a shallow start are no better for having more points.
        if (found && (!best || found->placed() > best->placed())) best = std::move(found);
        // Two that nothing can be added to are no more than a start.
        if (best && (best->placed() > 2 || model.pixels.size() == 2)) break;
    }
    if (best) model = std::move(*best);
}

}  // namespace lumi
