#include "pipeline/evaluate/evaluation.h"

#include <algorithm>

#include "calib/capture/image_io.h"
#include "calib/work/stopwatch.h"
#include "pipeline/evaluate/edge_sharpness.h"
#include "pipeline/evaluate/flip.h"
#include "pipeline/evaluate/gain_fit.h"
#include "pipeline/evaluate/ghost_energy.h"
#include "pipeline/evaluate/ghost_forecast.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

std::vector<double> sorted_frame_ms(OffscreenRenderer& renderer, const Eye& eye,
                                    const RenderOptions& options, int count) {
    std::vector<double> frame_ms;
    for (int i = 0; i < count; ++i) {
        const Stopwatch stopwatch;
        const Frame frame = renderer.draw(eye, options);
        frame_ms.push_back(1000.0 * stopwatch.elapsed().wall_s);
    }
    std::sort(frame_ms.begin(), frame_ms.end());
    return frame_ms;
}

std::vector<Eye> eyes_of(const PosedPhotographs& photographs) {
    std::vector<Eye> eyes;
    for (const View& view : photographs.capture.views) {
        eyes.push_back({camera_of(photographs.capture, view), view.cam_from_world});
    }
    return eyes;
}

void score_picture(JudgedView& judged) {
    const ColorImage& photograph = judged.photograph;
    const Frame& frame = judged.rendering;
    ViewScore& score = judged.score;
    score.psnr_db = psnr_db(photograph, frame.color);
    score.psnr_covered_db = psnr_db(photograph, frame.color, frame.coverage);
    score.ssim = structural_similarity(photograph, frame.color);
    score.coverage = covered_share(frame.coverage);
    judged.flip = flip_error_map(photograph, frame.color);
    score.flip = mean_error(judged.flip);
    score.flip_covered = mean_error(judged.flip, frame.coverage);
    score.edge_sharpness = edge_sharpness(photograph, frame.color, frame.coverage);
    if (const auto fit = fit_gain(photograph, frame.color, frame.coverage)) {
        score.psnr_gain_fitted_db = fit->psnr_db;
        score.gain = fit->gain;
    }
    if (judged.subject.empty()) return;
    score.psnr_subject_db = psnr_db(photograph, frame.color, judged.subject);
    score.flip_subject = mean_error(judged.flip, judged.subject);
    score.subject_coverage = covered_share(frame.coverage, judged.subject);
    score.subject_share = covered_share(judged.subject);
}

/// One run over all modes and views.
class HeldOutJudge {
 public:
    HeldOutJudge(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
                 const EvaluationOptions& options, Progress& progress)
        : lumigraph_(lumigraph),
          held_out_(held_out),
          options_(options),
          eyes_(eyes_of(held_out)),
          progress_(progress) {}

    Evaluation judge_all(const JudgedViewSink& keep) {
        std::vector<FloatImage> ghosts;
        if (options_.ghost_energy && !eyes_.empty()) {
            ghosts = ghost_energies(lumigraph_, eyes_, options_.modes.front(), progress_);
        }
        OffscreenRenderer renderer(lumigraph_);
        Evaluation evaluation;
        evaluation.gl_description = renderer.gl_description();
        evaluation.subject_from = options_.subject_from;
        progress_.begin("drawing held-out views", options_.modes.size() * eyes_.size());
        for (const RenderMode mode : options_.modes) {
            evaluation.modes.push_back(judge_mode(renderer, mode, ghosts, keep));
            ghosts.clear();  // They are of the first mode.
        }
        return evaluation;
    }

 private:
    ModeScores judge_mode(OffscreenRenderer& renderer, RenderMode mode,
                          std::vector<FloatImage>& ghosts, const JudgedViewSink& keep) {
        ModeScores scores{mode, {}, {}, {}};
        GhostForecast forecast;
        for (std::size_t i = 0; i < eyes_.size(); ++i) {
            progress_.throw_if_interrupted();
            JudgedView judged = judge(renderer, i, mode);
            if (!ghosts.empty()) {
                judged.ghost_energy = std::move(ghosts[i]);
                judged.score.ghost_energy = mean_error(judged.ghost_energy);
                forecast.add(judged.ghost_energy, judged.photograph, judged.rendering);
            }
            keep(mode, judged);
            scores.views.push_back(judged.score);
            progress_.advance();
        }
        scores.ghost_between_blocks = forecast.between_blocks();
        scores.ghost_between_views = forecast.between_views();
        return scores;
    }

    JudgedView judge(OffscreenRenderer& renderer, std::size_t index, RenderMode mode) const {
        const Eye& eye = eyes_[index];
        JudgedView judged;
        judged.score.name = held_out_.capture.views[index].name;
        judged.score.place = place_of_view(lumigraph_.mesh, eye.camera, eye.cam_from_world);
        judged.photograph = read_color_image(held_out_.picture_paths[index]);
        if (options_.subject_mask) {
            judged.subject = options_.subject_mask(judged.score.name, judged.photograph);
        }
        judged.rendering = renderer.draw(eye, {.mode = mode});
        score_picture(judged);
        const std::vector<double> frame_ms =
            sorted_frame_ms(renderer, eye, {.mode = mode}, std::max(1, options_.timed_frames));
        judged.score.ms = frame_ms[frame_ms.size() / 2];
        judged.score.fastest_ms = frame_ms.front();
        judged.score.slowest_ms = frame_ms.back();
        return judged;
    }

    const Lumigraph& lumigraph_;
    const PosedPhotographs& held_out_;
    const EvaluationOptions& options_;
    std::vector<Eye> eyes_;
    Progress& progress_;
};

}  // namespace

Evaluation evaluate_held_out(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
                             const EvaluationOptions& options, const JudgedViewSink& keep,
                             Progress& progress) {
    return HeldOutJudge(lumigraph, held_out, options, progress).judge_all(keep);
}

}  // namespace lumi
