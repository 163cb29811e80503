#include "meshing/depth/held_out_trial.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/capture/image_io.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth/depth_model.h"
#include "meshing/depth/finished_depth.h"
#include "meshing/depth/photograph_loss.h"
#include "meshing/depth/view_mask.h"

namespace lumi {
namespace {

constexpr std::size_t kMaxSampledViews = 4;
constexpr std::size_t kMaxComparedViews = 2;  // Of those, for rungs that compare photographs.
constexpr int kFolds = 4;
constexpr int kBlocksAlong = 4;  // Of a picture: errors in one block are not independent.

/// The views with enough points, each far from those before it.
std::vector<int> sampled_views(const DepthScene& scene) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.points.size() >= kMinTrialPoints && view.disparity_px_per_inverse_depth > 0) {
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
                   const std::vector<SparsePoint>& points, double px_per_inverse_depth,
                   int first_block, std::vector<Residual>& residuals) {
    for (const SparsePoint& point : points) {
        const int x = static_cast<int>(point.pixel.x());
        const int y = static_cast<int>(point.pixel.y());
        const double found = static_cast<double>(map.inverse_depth(x, y));
        const int block = first_block + y * kBlocksAlong / view.camera.height_px * kBlocksAlong +
                          x * kBlocksAlong / view.camera.width_px;
        residuals.push_back({block, std::abs(found - point.inverse_depth) * px_per_inverse_depth});
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

GrayImage halved(const GrayImage& mask, int width, int height) {
    if (mask.empty()) return mask;
    GrayImage half(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) half(x, y) = mask(2 * x, 2 * y);
    }
    return half;
}

/// The view at the size of the trial.
DepthView at_trial_size(const DepthView& view) {
    constexpr int kMinHalfWidth = 300;  // Of less, too little would remain to match.
    const int width = view.camera.width_px / 2;
    const int height = view.camera.height_px / 2;
    if (width < kMinHalfWidth) return view;
    DepthView half = view;
    half.camera = resized(view.camera, width, height);
    half.photograph = resized(view.photograph, width, height);
    const Eigen::Vector2d scale(1.0 * width / view.camera.width_px,
                                1.0 * height / view.camera.height_px);
    for (SparsePoint& point : half.points) point.pixel = scale.cwiseProduct(point.pixel);
    half.disparity_px_per_inverse_depth *= scale.x();
    return half;
}

/// A view and all that its finished depth is made from, but for one photograph.
class Exhibit {
 public:
    Exhibit(const DepthScene& scene, const std::vector<GrayImage>& masks, int subject,
            int kept_back)
        : source_(scene), source_masks_(masks), kept_back_(kept_back) {
        add(subject);
        // Those that must have depth of their own, and those that these are compared with.
        for (const int j : neighbours_of(subject)) add(j);
        witnesses_ = static_cast<int>(scene_.views.size());
        for (int i = 1; i < witnesses_; ++i) {
            for (const int j : neighbours_of(members_[static_cast<std::size_t>(i)])) add(j);
        }
        for (std::size_t i = 0; i < members_.size(); ++i) link(i);
    }

    /// The subject of the trial, at the size of the trial; its points may be kept back.
    [[nodiscard]] DepthView& subject() { return scene_.views.front(); }

    /// Depth of the subject as it would be delivered, and of its neighbours where they are to
    /// predict a photograph together.
    [[nodiscard]] std::vector<DepthMap> finished(const DepthModel& model,
                                                 bool with_neighbours) const {
        std::vector<DepthEstimate> estimates(scene_.views.size());
        estimate(model, 0, estimates);
        if (with_neighbours || estimates.front().needs_confirmation) {
            for (int i = 1; i < witnesses_; ++i) estimate(model, i, estimates);
        }
        for (int round = 0; round < model.refinements(); ++round) refine(model, estimates);
        std::vector<DepthMap> confirmed(scene_.views.size());  // Of the rest nothing is known.
        for (int i = 0; i < witnesses_; ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (estimates[index].map.confidence.empty()) continue;
            confirmed[index] = confirmed_depth(scene_, estimates, i);
        }
        std::vector<DepthMap> maps(confirmed.begin(),
                                   confirmed.begin() + (with_neighbours ? witnesses_ : 1));
        for (std::size_t i = 0; i < maps.size(); ++i) {
            if (!estimates[i].is_complete) {
                fill_unknown_depth(scene_, confirmed, static_cast<int>(i), maps[i]);
            }
            separate_background(masks_[i], maps[i]);
        }
        return maps;
    }

    /// How far a photograph is from what finished maps predict.
    [[nodiscard]] std::vector<double> loss_of(const std::vector<DepthMap>& maps,
                                              const DepthView& photograph) const {
        std::vector<PredictingView> views;
        for (std::size_t i = 0; i < maps.size(); ++i) {
            views.push_back({&scene_.views[i], &maps[i].inverse_depth});
        }
        return photograph_loss(views, at_trial_size(photograph));
    }

 private:
    [[nodiscard]] std::vector<int> neighbours_of(int view) const {
        std::vector<int> others = source_.views[static_cast<std::size_t>(view)].neighbours;
        std::erase(others, kept_back_);
        return others;
    }

    void add(int view) {
        if (std::find(members_.begin(), members_.end(), view) != members_.end()) return;
        members_.push_back(view);
        scene_.views.push_back(at_trial_size(source_.views[static_cast<std::size_t>(view)]));
        const Camera& camera = scene_.views.back().camera;
        const GrayImage& mask = source_masks_[static_cast<std::size_t>(view)];
        masks_.push_back(mask.width() == camera.width_px
                             ? mask
                             : halved(mask, camera.width_px, camera.height_px));
    }

    void link(std::size_t member) {
        std::vector<int>& linked = scene_.views[member].neighbours;
        linked.clear();
        for (const int j : neighbours_of(members_[member])) {
            const auto found = std::find(members_.begin(), members_.end(), j);
            if (found != members_.end()) {
                linked.push_back(static_cast<int>(found - members_.begin()));
            }
        }
    }

    void estimate(const DepthModel& model, int i, std::vector<DepthEstimate>& estimates) const {
        const auto index = static_cast<std::size_t>(i);
        estimates[index] = model.estimate(scene_, i);
        claim_nothing_beyond(masks_[index], estimates[index].map);
    }

    /// What has an estimate is made better; the rest of the views has said nothing.
    void refine(const DepthModel& model, std::vector<DepthEstimate>& estimates) const {
        const std::vector<DepthEstimate> before = estimates;
        for (int i = 0; i < witnesses_; ++i) {
            const auto index = static_cast<std::size_t>(i);
            if (before[index].map.confidence.empty()) continue;
            estimates[index] = model.refine(scene_, before, i);
            claim_nothing_beyond(masks_[index], estimates[index].map);
        }
    }

    const DepthScene& source_;
    const std::vector<GrayImage>& source_masks_;
    int kept_back_;
    DepthScene scene_;
    std::vector<GrayImage> masks_;
    std::vector<int> members_;  ///< Of the source scene, as they lie in `scene_`.
    int witnesses_ = 1;         ///< The subject and its neighbours come first.
};

struct ViewTrial {
    std::vector<Residual> residuals;
    std::vector<double> tiles;
};

/// One view, one part of its points kept back. Blocks are counted from `first_block` on.
void add_fold(const DepthScene& scene, const std::vector<GrayImage>& masks, const DepthModel& model,
              int view, int fold, int first_block, ViewTrial& result) {
    // Of the neighbours the second best is kept back. The best stays: without it nobody would
    // photograph.
    const DepthView& source = scene.views[static_cast<std::size_t>(view)];
    const int kept_back = source.neighbours.size() > 1 ? source.neighbours[1] : -1;
    Exhibit exhibit(scene, masks, view, kept_back);
    const std::vector<SparsePoint> back = keep_back(exhibit.subject(), fold);
    const bool is_predicted = kept_back >= 0 && fold == 0;
    const std::vector<DepthMap> maps = exhibit.finished(model, is_predicted);
    add_residuals(maps.front(), exhibit.subject(), back, source.disparity_px_per_inverse_depth,
                  first_block, result.residuals);
    if (is_predicted) {
        result.tiles = exhibit.loss_of(maps, scene.views[static_cast<std::size_t>(kept_back)]);
    }
}

}  // namespace

HeldOutTrial::HeldOutTrial(const DepthScene& scene, const std::vector<GrayImage>& masks,
                           int threads)
    : scene_(scene), masks_(masks), threads_(threads), views_(sampled_views(scene)) {}

Trial HeldOutTrial::of(const std::string& name, const Progress& progress) const {
    const std::unique_ptr<DepthModel> model = depth_model_named(name);
    // What compares photographs costs more, and hardly looks at the points: one part of them and
    // fewer views say enough.
    const bool is_costly = compares_photographs(name);
    const std::size_t views =
        is_costly ? std::min(views_.size(), kMaxComparedViews) : views_.size();
    std::vector<ViewTrial> by_view(views);
    parallel_for(static_cast<int>(views), threads_, [&](int k) {
        const auto index = static_cast<std::size_t>(k);
        for (int fold = 0; fold < (is_costly ? 1 : kFolds); ++fold) {
            progress.throw_if_interrupted();
            add_fold(scene_, masks_, *model, views_[index], fold, k * kBlocksAlong * kBlocksAlong,
                     by_view[index]);
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

}  // namespace lumi
