#include "pipeline/evaluate/rival_evaluation.h"

#include <utility>

#include "calib/work/stopwatch.h"
#include "pipeline/evaluate/common_pixels.h"
#include "pipeline/evaluate/resampled_pictures.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/rivals/rival_methods.h"
#include "render/surroundings/surroundings.h"

namespace lumi {
namespace {

class RivalJudge {
 public:
    RivalJudge(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
               const SubjectMask& subject_mask, int timed_frames, const JudgedRivalSink& keep,
               Progress& progress)
        : lumigraph_(lumigraph),
          held_out_(held_out),
          eyes_(eyes_of(held_out)),
          subject_mask_(subject_mask),
          timed_frames_(timed_frames),
          keep_(keep),
          progress_(progress) {}

    RivalEvaluation judge_all() {
        for (const PlainRival& rival : plain_rivals())
            if (can_draw(rival.name, rival.reason_against)) judge_plain(rival);
        for (const ResampledRival& rival : resampled_rivals())
            if (can_draw(rival.name, rival.reason_against)) judge_resampled(rival);
        return std::move(evaluation_);
    }

 private:
    bool can_draw(const std::string& method, ReasonAgainst reason_against) {
        std::string reason = reason_against(lumigraph_);
        if (reason.empty()) return true;
        evaluation_.left_out.push_back({method, std::move(reason)});
        return false;
    }

    void judge_plain(const PlainRival& rival) {
        judge_views({rival.name, rival.draws_from_depth}, 0.0, [&](const Eye& eye) {
            TimedFrame timed;
            timed.times = times_of(1, [&] {
                timed.frame = rival.draw(lumigraph_, eye, depths_for(rival, lumigraph_, eye));
            });
            timed.frame = filled(std::move(timed.frame), surroundings_picture(lumigraph_, eye));
            return timed;
        });
    }

    void judge_resampled(const ResampledRival& rival) {
        progress_.note("resampling for " + rival.name);
        const Stopwatch stopwatch;
        const ResampledPictures pictures = resampled_pictures(rival, lumigraph_, progress_);
        const double cpu_s = stopwatch.elapsed().cpu_s;
        OffscreenRenderer renderer(pictures.lumigraph);
        for (const RenderMode mode : {RenderMode::kLightField, RenderMode::kAdaptive})
            judge_views({rival.name + ' ' + name_of(mode)}, cpu_s, [&](const Eye& eye) {
                return timed_frame(renderer, eye, pictures.on_shared_plane({.mode = mode}),
                                   timed_frames_);
            });
    }

    using DrawAndTime = std::function<TimedFrame(const Eye& eye)>;
    void judge_views(const ComparedMethod& method, double resampling_cpu_s,
                     const DrawAndTime& draw) {
        RivalScores scores{method.name, {}, resampling_cpu_s};
        progress_.begin("drawing held-out views by " + method.name, eyes_.size());
        for (std::size_t i = 0; i < eyes_.size(); ++i) {
            progress_.throw_if_interrupted();
            TimedFrame timed = draw(eyes_[i]);
            const JudgedView judged = judged_view(held_out_, i, lumigraph_, subject_mask_,
                                                  std::move(timed.frame), timed.times);
            keep_(method, judged);
            scores.views.push_back(judged.score);
            progress_.advance();
        }
        evaluation_.methods.push_back(std::move(scores));
    }

    const Lumigraph& lumigraph_;
    const PosedPhotographs& held_out_;
    std::vector<Eye> eyes_;
    const SubjectMask& subject_mask_;
    int timed_frames_;
    const JudgedRivalSink& keep_;
    Progress& progress_;
    RivalEvaluation evaluation_;
};

}  // namespace

RivalEvaluation evaluate_rivals(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
                                const SubjectMask& subject_mask, int timed_frames,
                                const JudgedRivalSink& keep, Progress& progress) {
    return RivalJudge(lumigraph, held_out, subject_mask, timed_frames, keep, progress).judge_all();
}

}  // namespace lumi
