#include "pipeline/evaluate/evaluation.h"

#include <utility>

#include "pipeline/evaluate/flip.h"
#include "pipeline/evaluate/ghost_energy.h"
#include "pipeline/evaluate/ghost_forecast.h"
#include "render/renderer/offscreen_renderer.h"

namespace lumi {
namespace {

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
        TimedFrame timed =
            timed_frame(renderer, eyes_[index], {.mode = mode}, options_.timed_frames);
        return judged_view(held_out_, index, lumigraph_, options_.subject_mask,
                           std::move(timed.frame), timed.times);
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
