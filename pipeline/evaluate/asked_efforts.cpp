#include "pipeline/evaluate/asked_efforts.h"

#include <string>

#include "calib/work/error.h"
#include "pipeline/evaluate/depth_effort.h"
#include "pipeline/evaluate/depth_mesh_effort.h"
#include "pipeline/evaluate/kept_back_photographs.h"
#include "pipeline/evaluate/occlusion_effort.h"
#include "pipeline/evaluate/triangle_effort.h"

namespace lumi {
namespace {

/// What photographs say, as long as anything can be drawn here; then what holds by default.
class Asking {
 public:
    explicit Asking(Progress& progress) : progress_(progress) {}

    template <typename Ask>
    auto operator()(const Ask& ask) -> decltype(ask()) {
        if (!can_draw_) return {};
        try {
            return ask();
        } catch (const Error& error) {
            if (!error.code().starts_with("E-GL-")) throw;
            can_draw_ = false;
            progress_.note(std::string("nothing can be drawn here to see how much is enough: ") +
                           error.what());
            return {};
        }
    }

 private:
    Progress& progress_;
    bool can_draw_ = true;
};

/// What is done, and what photographs say to it.
template <typename Effort>
Effort noted(Effort effort, Progress& progress) {
    if (const std::string text = text_of(effort); !text.empty()) progress.note("pack: " + text);
    return effort;
}

/// Asks one after the other, each with what was chosen before.
class DrawingQuestions {
 public:
    DrawingQuestions(KeptBackPhotographs& photographs, const DrawingOptions& wanted,
                     Progress& progress)
        : photographs_(photographs), wanted_(wanted), progress_(progress), asked_(progress) {}

    [[nodiscard]] OcclusionEffort occlusion(const DrawingChoices& drawing) {
        if (wanted_.occlusion_tolerance_px != 0)
            return {.tolerance_px = wanted_.occlusion_tolerance_px};
        return noted(asked_([&] { return sufficient_occlusion_effort(photographs_, drawing); }),
                     progress_);
    }

    [[nodiscard]] DepthEffort depth(const DrawingChoices& drawing) {
        DepthEffort effort;
        if (wanted_.depth_views == 0 || wanted_.depth_block_px == 0 || !wanted_.fill_holes ||
            !wanted_.check_guesses)
            effort = asked_([&] {
                return sufficient_depth_effort(photographs_, drawing, wanted_.depth_views);
            });
        if (wanted_.depth_views != 0) effort.views = wanted_.depth_views;
        if (wanted_.depth_block_px != 0) effort.block_px = wanted_.depth_block_px;
        effort.fills_holes = wanted_.fill_holes.value_or(effort.fills_holes);
        effort.checks_guesses = wanted_.check_guesses.value_or(effort.checks_guesses);
        return noted(effort, progress_);
    }

    [[nodiscard]] TriangleEffort triangles(const DrawingChoices& drawing) {
        TriangleEffort effort;
        if (wanted_.triangle_error_px == 0 || !wanted_.draw_thin)
            effort = asked_([&] {
                return sufficient_triangle_effort(photographs_, drawing, wanted_.triangle_error_px);
            });
        if (wanted_.triangle_error_px != 0) {
            effort.error_px = wanted_.triangle_error_px;
            effort.loses_db = effort.triangles = 0;  // Were those of another.
        }
        effort.draws_thin = wanted_.draw_thin.value_or(effort.draws_thin);
        return noted(effort, progress_);
    }

 private:
    KeptBackPhotographs& photographs_;
    const DrawingOptions& wanted_;
    Progress& progress_;
    Asking asked_;
};

}  // namespace

DepthMeshEffort asked_depth_mesh_effort(const Lumigraph& lumigraph, const Capture& capture,
                                        const CameraMeshOptions& mesh_options,
                                        const DrawingOptions& wanted, Progress& progress) {
    if (wanted.noisy_depth_error_px != 0) return {.noisy_error_px = wanted.noisy_depth_error_px};
    Asking asked(progress);
    return noted(asked([&] {
                     return sufficient_depth_mesh_effort(lumigraph, capture, mesh_options,
                                                         wanted.occlusion_tolerance_px, progress);
                 }),
                 progress);
}

DrawingEfforts asked_drawing_efforts(const Lumigraph& lumigraph, const Capture& capture,
                                     const CameraMeshOptions& mesh_options,
                                     const DrawingOptions& wanted, Progress& progress) {
    KeptBackPhotographs photographs(lumigraph, capture, mesh_options, progress);
    DrawingQuestions questions(photographs, wanted, progress);
    DrawingChoices drawing = lumigraph.drawing;
    DrawingEfforts efforts;
    efforts.occlusion = questions.occlusion(drawing);
    choose(efforts.occlusion, drawing);
    efforts.depth = questions.depth(drawing);
    choose(efforts.depth, drawing);
    efforts.triangles = questions.triangles(drawing);
    return efforts;
}

}  // namespace lumi
