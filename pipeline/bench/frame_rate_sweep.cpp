#include "pipeline/bench/frame_rate_sweep.h"

#include <algorithm>
#include <utility>

#include "calib/work/median.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/bench/budgeted_frames.h"
#include "render/lumigraph/even_exposure.h"
#include "render/paths/pose_between.h"

namespace lumi {
namespace {

/// From each photograph to the next, the first of them at the photograph.
constexpr std::size_t kFramesOfALeg = 12;

/// Ends where it begins.
std::vector<Eye> path_through(const std::vector<HeldOutView>& held_out) {
    std::vector<Eye> path;
    for (std::size_t i = 0; i < held_out.size(); ++i) {
        const Eye& from = held_out[i].eye;
        const Eye& to = held_out[(i + 1) % held_out.size()].eye;
        path.push_back(from);
        for (std::size_t k = 1; k < kFramesOfALeg; ++k)
            path.push_back({from.camera, pose_between(from.cam_from_world, to.cam_from_world,
                                                      static_cast<double>(k) / kFramesOfALeg)});
    }
    return path;
}

/// The frames of one budget.
struct FramesOfBudget {
    std::vector<double> wall_ms;
    std::vector<double> triangles;
    double sum_db = 0.0;
};

FrameRateFigures figures_of(double asked, FramesOfBudget frames, std::size_t photographs) {
    const auto in_time = std::count_if(frames.wall_ms.begin(), frames.wall_ms.end(),
                                       [&](double ms) { return asked <= 0 || ms <= 1000 / asked; });
    const double share = static_cast<double>(in_time) / static_cast<double>(frames.wall_ms.size());
    return {asked, 1000 / median_of(std::move(frames.wall_ms)), share,
            median_of(std::move(frames.triangles)),
            frames.sum_db / static_cast<double>(photographs)};
}

}  // namespace

std::vector<FrameRateFigures> sweep_frame_rates(const Lumigraph& lumigraph,
                                                const std::vector<HeldOutView>& held_out,
                                                const std::vector<double>& frames_per_second,
                                                Progress& progress) {
    std::vector<double> asked{0.0};
    asked.insert(asked.end(), frames_per_second.begin(), frames_per_second.end());
    std::vector<FramesOfBudget> budgets(asked.size());
    draw_within_budgets(
        lumigraph, path_through(held_out), asked,
        [&](const BudgetedFrame& drawn) {
            FramesOfBudget& frames = budgets[drawn.budget];
            frames.wall_ms.push_back(drawn.wall_ms);
            frames.triangles.push_back(static_cast<double>(drawn.statistics.triangles));
            if (drawn.place % kFramesOfALeg != 0) return;
            const HeldOutView& view = held_out[drawn.place / kFramesOfALeg];
            frames.sum_db += psnr_db(
                darkened_by_lens(drawn.frame.color, view.eye.camera, lumigraph.evened_falloff),
                view.photograph);
        },
        progress);
    std::vector<FrameRateFigures> figures;
    for (std::size_t i = 0; i < asked.size(); ++i)
        figures.push_back(figures_of(asked[i], std::move(budgets[i]), held_out.size()));
    return figures;
}

}  // namespace lumi
