#include "render/bench/budgeted_frames.h"

#include <epoxy/gl.h>

#include "calib/work/stopwatch.h"
#include "render/gl/headless_context.h"
#include "render/renderer/frame_target.h"
#include "render/subdivision/triangle_budget.h"

namespace lumi {

void draw_within_budgets(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                         const std::vector<double>& frames_per_second,
                         const BudgetedFrameSink& sink, Progress& progress) {
    const HeadlessContext context;
    LumigraphRenderer renderer(lumigraph);
    FrameTarget target;
    const RenderOptions options{.mode = RenderMode::kAdaptive};
    // What only the first frame of all does, it shall not teach.
    target.draw(renderer, path.front(), options);
    progress.begin("drawing within budgets", 2 * path.size() * frames_per_second.size());
    for (std::size_t i = 0; i < frames_per_second.size(); ++i) {
        TriangleBudget budget(frames_per_second[i]);
        for (std::size_t drawn = 0; drawn < 2 * path.size(); ++drawn) {
            progress.throw_if_interrupted();
            const std::size_t place = drawn % path.size();
            renderer.forget_frame();
            glFinish();
            const Stopwatch stopwatch;
            const DrawStatistics statistics =
                target.draw(renderer, path[place], budget.within(options));
            glFinish();
            const double wall_ms = 1000 * stopwatch.elapsed().wall_s;
            budget.measured(statistics.triangles, wall_ms);
            if (drawn >= path.size()) sink({i, place, wall_ms, statistics, target.read()});
            progress.advance();
        }
    }
}

}  // namespace lumi
