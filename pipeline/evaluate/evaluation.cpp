#include "pipeline/evaluate/evaluation.h"

#include <algorithm>

#include "calib/capture/image_io.h"
#include "calib/work/stopwatch.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/modes/offscreen_renderer.h"

namespace lumi {
namespace {

constexpr int kTimedFrames = 5;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

double median_frame_ms(OffscreenRenderer& renderer, const Eye& eye, const RenderOptions& options) {
    std::vector<double> frame_ms;
    for (int i = 0; i < kTimedFrames; ++i) {
        const Stopwatch stopwatch;
        const Frame frame = renderer.draw(eye, options);
        frame_ms.push_back(1000.0 * stopwatch.elapsed().wall_s);
    }
    return median(std::move(frame_ms));
}

JudgedView judge(OffscreenRenderer& renderer, const PosedPhotographs& held_out, std::size_t index,
                 const RenderOptions& options) {
    const View& view = held_out.capture.views[index];
    const Eye eye{camera_of(held_out.capture, view), view.cam_from_world};
    JudgedView judged;
    judged.photograph = read_color_image(held_out.picture_paths[index]);
    judged.rendering = renderer.draw(eye, options);
    judged.score = {view.name,
                    psnr_db(judged.photograph, judged.rendering.color),
                    psnr_db(judged.photograph, judged.rendering.color, judged.rendering.coverage),
                    structural_similarity(judged.photograph, judged.rendering.color),
                    covered_share(judged.rendering.coverage),
                    median_frame_ms(renderer, eye, options)};
    return judged;
}

}  // namespace

ViewScore mean_score(const std::vector<ViewScore>& views) {
    ViewScore mean;
    mean.name = "mean";
    double psnr_covered_db = 0.0;
    int covered = 0;
    for (const ViewScore& view : views) {
        mean.psnr_db += view.psnr_db;
        mean.ssim += view.ssim;
        mean.coverage += view.coverage;
        mean.ms += view.ms;
        if (view.psnr_covered_db) {
            psnr_covered_db += *view.psnr_covered_db;
            ++covered;
        }
    }
    const double count = std::max(1.0, static_cast<double>(views.size()));
    mean.psnr_db /= count;
    mean.ssim /= count;
    mean.coverage /= count;
    mean.ms /= count;
    if (covered > 0) mean.psnr_covered_db = psnr_covered_db / covered;
    return mean;
}

Evaluation evaluate_held_out(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
                             const std::vector<RenderMode>& modes, const JudgedViewSink& keep,
                             Progress& progress) {
    OffscreenRenderer renderer(lumigraph);
    Evaluation evaluation;
    evaluation.gl_description = renderer.gl_description();
    progress.begin("drawing held-out views", modes.size() * held_out.capture.views.size());
    for (const RenderMode mode : modes) {
        ModeScores scores{mode, {}};
        for (std::size_t i = 0; i < held_out.capture.views.size(); ++i) {
            progress.throw_if_interrupted();
            const JudgedView judged = judge(renderer, held_out, i, {.mode = mode});
            keep(mode, judged);
            scores.views.push_back(judged.score);
            progress.advance();
        }
        evaluation.modes.push_back(std::move(scores));
    }
    return evaluation;
}

}  // namespace lumi
