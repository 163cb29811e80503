#include "meshing/depth/depth_choice.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/work/parallel_for.h"
#include "meshing/depth/photograph_loss.h"

namespace lumi {
namespace {

constexpr std::size_t kMinPoints = 40;
constexpr std::size_t kMaxSampledViews = 4;
constexpr std::size_t kMaxComparedViews = 2;  // Of those, for rungs that compare photographs.
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

/// What one rung got wrong on the sampled views.
struct Trial {
    RungLoss loss;
    /// Of the photographs kept back, view by view in the order of the sample; maybe of fewer views.
    std::vector<double> tiles;
};

/// Asks a model for what it was not told: points of the view, and the photograph of a neighbour.
class HeldOutTrial {
 public:
    HeldOutTrial(const DepthScene& scene, int threads)
        : scene_(scene), threads_(threads), views_(sampled_views(scene)) {}

    [[nodiscard]] bool is_possible() const { return !views_.empty(); }

    [[nodiscard]] Trial of(const std::string& name, const Progress& progress) const {
        const std::unique_ptr<DepthModel> model = depth_model_named(name);
        // What compares photographs costs more, and hardly looks at the points: one part of them
        // and fewer views say enough.
        const bool is_costly = compares_photographs(name);
        const std::size_t views =
            is_costly ? std::min(views_.size(), kMaxComparedViews) : views_.size();
        std::vector<ViewTrial> by_view(views);
        parallel_for(static_cast<int>(views), threads_, [&](int k) {
            const auto index = static_cast<std::size_t>(k);
            for (int fold = 0; fold < (is_costly ? 1 : kFolds); ++fold) {
                progress.throw_if_interrupted();
                add_fold(*model, k, fold, by_view[index]);
            }
        });
        std::vector<Residual> residuals;
        Trial trial;
        for (const ViewTrial& view : by_view) {
            residuals.insert(residuals.end(), view.residuals.begin(), view.residuals.end());
            trial.tiles.insert(trial.tiles.end(), view.tiles.begin(), view.tiles.end());
        }
        trial.loss = loss_of(name, std::move(residuals));
        trial.loss.photograph = rms_of(trial.tiles);
        return trial;
    }

 private:
    struct ViewTrial {
        std::vector<Residual> residuals;
        std::vector<double> tiles;
    };

    void add_fold(const DepthModel& model, int sample, int fold, ViewTrial& result) const {
        // A scene of its own: the view with its neighbours, but for the second best, whose
        // photograph is to be predicted. The best stays: without it nobody would photograph.
        constexpr std::size_t kKeptBack = 1;
        const DepthView& source =
            scene_.views[static_cast<std::size_t>(views_[static_cast<std::size_t>(sample)])];
        const DepthView* kept_back = nullptr;
        DepthScene trial;
        trial.views.push_back(source);
        trial.views.front().neighbours.clear();
        for (std::size_t n = 0; n < source.neighbours.size(); ++n) {
            const DepthView& other = scene_.views[static_cast<std::size_t>(source.neighbours[n])];
            if (n == kKeptBack) {
                kept_back = &other;
                continue;
            }
            trial.views.front().neighbours.push_back(static_cast<int>(trial.views.size()));
            trial.views.push_back(other);
        }
        const std::vector<SparsePoint> back = keep_back(trial.views.front(), fold);
        const DepthEstimate estimate = model.estimate(trial, 0);
        add_residuals(estimate.map, source, back, sample * kBlocksAlong * kBlocksAlong,
                      result.residuals);
        if (kept_back != nullptr && fold == 0) {
            result.tiles = photograph_loss(source, estimate.map.inverse_depth, *kept_back);
        }
    }

    const DepthScene& scene_;
    int threads_;
    std::vector<int> views_;
};

std::string with_two_digits(double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 3);
}

/// Climbs from rung to rung.
class Climb {
 public:
    Climb(const HeldOutTrial& trial, const Progress& progress)
        : trial_(trial), progress_(progress) {}

    DepthChoice run(const std::vector<std::string>& rungs) {
        for (const std::string& rung : rungs) {
            Trial next = trial_.of(rung, progress_);
            choice_.losses.push_back(next.loss);
            // One rung may fail where the next succeeds: pairs that cannot be rectified, points too
            // few to fill between. All are asked.
            if (choice_.model.empty() || is_better(next)) {
                choice_.model = rung;
                accepted_ = std::move(next);
            }
            if (accepted_.loss.p95_px < kEnoughPx) {
                choice_.explanation = choice_.model + ": 95 % of the points kept back lie within " +
                                      with_two_digits(accepted_.loss.p95_px) + " px of it";
                return choice_;
            }
        }
        choice_.explanation =
            choice_.model + ": " + evidence_of(accepted_.loss) +
            (choice_.model == rungs.back() ? ", clearly closer than the rungs below"
                                           : ", and no rung above it is clearly closer");
        return choice_;
    }

 private:
    static constexpr double kEnoughPx = 1.0;

    [[nodiscard]] static std::string evidence_of(const RungLoss& loss) {
        if (loss.photograph > 0) {
            return "predicts photographs kept back to " + with_two_digits(loss.photograph) +
                   " grey levels";
        }
        return "off by " + with_two_digits(loss.mean_px) + " px at points kept back";
    }

    /// Points lie on texture, where any rung does well: between them the photographs tell.
    [[nodiscard]] bool is_better(const Trial& next) const {
        if (!next.tiles.empty()) return is_clearly_closer(next.tiles, accepted_.tiles);
        return next.loss.mean_px +
                   std::max(next.loss.standard_error_px, accepted_.loss.standard_error_px) <
               accepted_.loss.mean_px;
    }

    const HeldOutTrial& trial_;
    const Progress& progress_;
    DepthChoice choice_;
    Trial accepted_;
};

}  // namespace

DepthChoice choose_depth_model(const DepthScene& scene, const std::string& highest, int threads,
                               Progress& progress) {
    const HeldOutTrial trial(scene, threads);
    if (!trial.is_possible()) {
        return {highest,
                highest + ": no view has " + std::to_string(kMinPoints) +
                    " scene points, by which a cheaper model could be judged",
                {}};
    }
    std::vector<std::string> rungs = depth_model_names();
    rungs.erase(std::find(rungs.begin(), rungs.end(), highest) + 1, rungs.end());
    progress.begin("depth: choosing a model", 0);
    return Climb(trial, progress).run(rungs);
}

}  // namespace lumi
