#include "meshing/depth/held_out_points.h"

#include <cmath>
#include <utility>
#include <vector>

#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_models/sparse_depth.h"
#include "meshing/depth_scene/views_far_apart.h"

namespace lumi {
namespace {

constexpr int kMaxHeldOutViews = 4;
constexpr std::size_t kFolds = 4;

std::vector<int> sampled_views(const DepthScene& scene) {
    std::vector<int> candidates;
    for (std::size_t i = 0; i < scene.views.size(); ++i) {
        const DepthView& view = scene.views[i];
        if (view.points.size() >= kMinTrialPoints && view.disparity_px_per_inverse_depth > 0) {
            candidates.push_back(static_cast<int>(i));
        }
    }
    return views_far_apart(scene, candidates, kMaxHeldOutViews);
}

/// The view, and what it is compared with.
DepthScene part_of(const DepthScene& scene, int view_index, bool with_neighbours) {
    DepthScene part;
    part.views.push_back(scene.views[static_cast<std::size_t>(view_index)]);
    const std::vector<int> neighbours = std::exchange(part.views.front().neighbours, {});
    if (!with_neighbours) return part;
    for (const int j : neighbours) {
        part.views.front().neighbours.push_back(static_cast<int>(part.views.size()));
        part.views.push_back(scene.views[static_cast<std::size_t>(j)]);
        part.views.back().neighbours.clear();
    }
    return part;
}

/// How far a rung is from one point.
struct Residual {
    double px = 0.0;
    bool agrees = true;  ///< The point, with those around it.
};

std::vector<Residual> residuals_of(const DepthScene& scene, int view_index, const DepthModel& model,
                                   bool compares) {
    DepthScene part = part_of(scene, view_index, compares);
    DepthView& view = part.views.front();
    const std::vector<SparsePoint> all = view.points;
    const double px = view.disparity_px_per_inverse_depth;
    const std::vector<char> agree = agree_with_surroundings(all, kAstrayPx / px);
    std::vector<Residual> residuals;
    for (std::size_t fold = 0; fold < (compares ? 1 : kFolds); ++fold) {
        view.points.clear();
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (i % kFolds != fold) view.points.push_back(all[i]);
        }
        const DepthMap map = model.estimate(part, 0).map;
        for (std::size_t i = fold; i < all.size(); i += kFolds) {
            const double found = static_cast<double>(map.inverse_depth(
                static_cast<int>(all[i].pixel.x()), static_cast<int>(all[i].pixel.y())));
            residuals.push_back({std::abs(found - all[i].inverse_depth) * px, agree[i] != 0});
        }
    }
    return residuals;
}

HeldOutPoints summary_of(const std::vector<Residual>& residuals) {
    std::vector<double> all_px;
    std::size_t agreeing = 0;
    std::size_t astray = 0;
    for (const Residual& residual : residuals) {
        all_px.push_back(residual.px);
        if (!residual.agrees) continue;
        ++agreeing;
        if (residual.px > kAstrayPx) ++astray;
    }
    const std::size_t p95 = all_px.size() * 95 / 100;
    return {value_of_rank(std::move(all_px), p95),
            agreeing == 0 ? 0.0 : static_cast<double>(astray) / static_cast<double>(agreeing)};
}

}  // namespace

std::optional<HeldOutPoints> held_out_points(const DepthScene& scene, const std::string& model,
                                             int threads, const Progress& progress) {
    const std::vector<int> views = sampled_views(scene);
    const std::unique_ptr<DepthModel> rung = depth_model_named(model);
    const bool compares = compares_photographs(model);
    std::vector<std::vector<Residual>> by_view(views.size());
    // What matches takes its memory at full size: never that of more views than maps will be made
    // of at one time.
    parallel_for(static_cast<int>(views.size()), compares ? 1 : threads, [&](int k) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(k);
        by_view[index] = residuals_of(scene, views[index], *rung, compares);
    });
    std::vector<Residual> residuals;
    for (const std::vector<Residual>& some : by_view) {
        residuals.insert(residuals.end(), some.begin(), some.end());
    }
    if (residuals.empty()) return std::nullopt;
    return summary_of(residuals);
}

}  // namespace lumi
