#include "meshing/depth/depth_choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/work/parallel_for.h"
#include "meshing/depth/tile_search.h"

namespace lumi {
namespace {

constexpr std::size_t kMinPoints = 40;
constexpr std::size_t kMaxSampledViews = 4;
constexpr int kFolds = 4;
constexpr int kBlocksAlong = 4;  // Of a picture: errors in one block are not independent.

/// The views with enough points, each far from those before it.
std::vector<int> sampled_views(const DepthScene& scene) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.points.size() >= kMinPoints && view.disparity_px_per_inverse_depth > 0) {
            candidates.push_back(static_cast<int>(i));
        }
    }
    const auto centre = [&](int i) {
        return centre_in_world(scene.views[static_cast<std::size_t>(i)].cam_from_world);
    };
    std::vector<int> chosen;
    while (!candidates.empty() && chosen.size() < kMaxSampledViews) {
        const auto distance = [&](int i) {
            double nearest = chosen.empty() ? 0.0 : std::numeric_limits<double>::infinity();
            for (const int j : chosen) nearest = std::min(nearest, (centre(i) - centre(j)).norm());
            return nearest;
        };
        const auto next = std::max_element(candidates.begin(), candidates.end(),
                                           [&](int a, int b) { return distance(a) < distance(b); });
        chosen.push_back(*next);
        candidates.erase(next);
    }
    return chosen;
}

struct Residual {
    int block = 0;
    double px = 0.0;
};

/// The scene with a part of one view's points kept back from it.
std::vector<SparsePoint> keep_back(DepthView& view, int fold) {
    std::vector<SparsePoint> kept;
    std::vector<SparsePoint> back;
    for (std::size_t i = 0; i < view.points.size(); ++i) {
        (static_cast<int>(i % kFolds) == fold ? back : kept).push_back(view.points[i]);
    }
    view.points = std::move(kept);
    return back;
}

void add_residuals(const DepthMap& map, const DepthView& view,
                   const std::vector<SparsePoint>& points, int first_block,
                   std::vector<Residual>& residuals) {
    for (const SparsePoint& point : points) {
        const int x = static_cast<int>(point.pixel.x());
        const int y = static_cast<int>(point.pixel.y());
        const double found = static_cast<double>(map.inverse_depth(x, y));
        const int block = first_block + y * kBlocksAlong / view.camera.height_px * kBlocksAlong +
                          x * kBlocksAlong / view.camera.width_px;
        residuals.push_back(
            {block, std::abs(found - point.inverse_depth) * view.disparity_px_per_inverse_depth});
    }
}

RungLoss loss_of(const std::string& model, std::vector<Residual> residuals) {
    RungLoss loss{model, 0, 0, 0};
    if (residuals.empty()) return loss;
    std::sort(residuals.begin(), residuals.end(),
              [](const Residual& a, const Residual& b) { return a.px < b.px; });
    loss.p95_px = residuals[residuals.size() * 95 / 100].px;
    std::vector<double> sums;
    std::vector<double> counts;
    for (const Residual& residual : residuals) {
        const auto block = static_cast<std::size_t>(residual.block);
        sums.resize(std::max(sums.size(), block + 1));
        counts.resize(sums.size());
        sums[block] += std::min(residual.px, kMaxLossPx);
        counts[block] += 1;
    }
    const auto total = static_cast<double>(residuals.size());
    loss.mean_px = std::accumulate(sums.begin(), sums.end(), 0.0) / total;
    // Of a ratio of sums over blocks (Cochran 1977, section 2.11).
    double squares = 0;
    double blocks = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        if (counts[i] == 0) continue;
        squares += std::pow(sums[i] - loss.mean_px * counts[i], 2);
        ++blocks;
    }
    if (blocks > 1) loss.standard_error_px = std::sqrt(squares * blocks / (blocks - 1)) / total;
    return loss;
}

bool compares_photographs(const std::string& model) {
    return model == "pair_stereo" || model == "sweep" || model == "patch_match";
}

/// Asks the model for what it was not told, on the sampled views.
class PointTrial {
 public:
    PointTrial(const DepthScene& scene, int threads)
        : scene_(scene), threads_(threads), views_(sampled_views(scene)) {}

    [[nodiscard]] bool is_possible() const { return !views_.empty(); }

    [[nodiscard]] RungLoss loss(const std::string& name, const Progress& progress) const {
        const std::unique_ptr<DepthModel> model = depth_model_named(name);
        // What compares photographs hardly looks at the points: one part says enough.
        const int folds = compares_photographs(name) ? 1 : kFolds;
        std::vector<std::vector<Residual>> by_view(views_.size());
        parallel_for(static_cast<int>(views_.size()), threads_, [&](int k) {
            const auto index = static_cast<std::size_t>(k);
            for (int fold = 0; fold < folds; ++fold) {
                progress.throw_if_interrupted();
                add_fold(*model, views_[index], k * kBlocksAlong * kBlocksAlong, fold,
                         by_view[index]);
            }
        });
        std::vector<Residual> all;
        for (const auto& residuals : by_view)
            all.insert(all.end(), residuals.begin(), residuals.end());
        return loss_of(name, std::move(all));
    }

 private:
    void add_fold(const DepthModel& model, int view_index, int first_block, int fold,
                  std::vector<Residual>& residuals) const {
        // A scene of its own: the view with its neighbours.
        const DepthView& source = scene_.views[static_cast<std::size_t>(view_index)];
        DepthScene trial;
        trial.views.push_back(source);
        for (int& neighbour : trial.views.front().neighbours) {
            trial.views.push_back(scene_.views[static_cast<std::size_t>(neighbour)]);
            neighbour = static_cast<int>(trial.views.size()) - 1;
        }
        const std::vector<SparsePoint> back = keep_back(trial.views.front(), fold);
        const DepthEstimate estimate = model.estimate(trial, 0);
        add_residuals(estimate.map, source, back, first_block, residuals);
    }

    const DepthScene& scene_;
    int threads_;
    std::vector<int> views_;
};

std::string in_px(double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 3);
}

/// True when the errors of `next` are smaller by more than a standard error of the difference.
bool is_clearly_better(const std::vector<double>& next, const std::vector<double>& current) {
    if (next.size() != current.size() || next.size() < 2) return false;
    const auto count = static_cast<double>(next.size());
    double mean = 0;
    for (std::size_t i = 0; i < next.size(); ++i) mean += (current[i] - next[i]) / count;
    double squares = 0;
    for (std::size_t i = 0; i < next.size(); ++i) {
        squares += std::pow(current[i] - next[i] - mean, 2);
    }
    return mean > std::sqrt(squares / (count * (count - 1)));
}

/// Climbs from rung to rung.
class Climb {
 public:
    Climb(const PointTrial& trial, const RenderedLoss& rendered_loss, const Progress& progress)
        : trial_(trial), rendered_loss_(rendered_loss), progress_(progress) {}

    DepthChoice run(const std::vector<std::string>& rungs) {
        accept(trial_.loss(rungs.front(), progress_));
        choice_.losses.push_back(accepted_);
        std::size_t since = 0;
        for (std::size_t i = 1; i < rungs.size(); ++i) {
            if (accepted_.p95_px < kEnoughPx) {
                choice_.explanation = accepted_.model +
                                      ": 95 % of the points kept back lie within " +
                                      in_px(accepted_.p95_px) + " px of it";
                return choice_;
            }
            const RungLoss loss = trial_.loss(rungs[i], progress_);
            choice_.losses.push_back(loss);
            const bool better = is_better(loss);
            since = better ? 0 : since + 1;
            if (better) accept(loss);
            // One rung may fail where the next succeeds: pairs that cannot be rectified, points too
            // few to fill between. Photographs are always asked.
            if (since > 1 && compares_photographs(rungs[i])) break;
        }
        if (choice_.explanation.empty() || since > 0) {
            choice_.explanation = accepted_.model + ": off by " + in_px(accepted_.mean_px) +
                                  " px on average at points kept back, and no rung tried above it "
                                  "is better by more than a standard error";
        }
        if (since == 0) {
            choice_.explanation = accepted_.model + ": the last rung tried, off by " +
                                  in_px(accepted_.mean_px) +
                                  " px on average at points kept back, and better than those below";
        }
        return choice_;
    }

 private:
    static constexpr double kEnoughPx = 1.0;

    void accept(const RungLoss& loss) {
        accepted_ = loss;
        choice_.model = loss.model;
    }

    bool is_better(const RungLoss& loss) {
        const bool at_points =
            loss.mean_px + std::max(loss.standard_error_px, accepted_.standard_error_px) <
            accepted_.mean_px;
        if (!rendered_loss_ || !compares_photographs(loss.model)) return at_points;
        if (!compares_photographs(accepted_.model) && !at_points) return false;
        const std::vector<double> next = rendered_loss_(loss.model);
        if (next.empty()) return at_points;
        if (rendered_of_ != accepted_.model) rendered_ = rendered_loss_(accepted_.model);
        if (!is_clearly_better(next, rendered_)) return false;
        rendered_ = next;
        rendered_of_ = loss.model;
        return true;
    }

    const PointTrial& trial_;
    const RenderedLoss& rendered_loss_;
    const Progress& progress_;
    DepthChoice choice_;
    RungLoss accepted_;
    std::vector<double> rendered_;
    std::string rendered_of_;
};

}  // namespace

DepthChoice choose_depth_model(const DepthScene& scene, const std::string& highest,
                               const RenderedLoss& rendered_loss, int threads, Progress& progress) {
    const PointTrial trial(scene, threads);
    if (!trial.is_possible()) {
        return {highest,
                highest + ": no view has " + std::to_string(kMinPoints) +
                    " scene points, by which a cheaper model could be judged",
                {}};
    }
    std::vector<std::string> rungs = depth_model_names();
    rungs.erase(std::find(rungs.begin(), rungs.end(), highest) + 1, rungs.end());
    progress.begin("depth: choosing a model", 0);
    return Climb(trial, rendered_loss, progress).run(rungs);
}

}  // namespace lumi
