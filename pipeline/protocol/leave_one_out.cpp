#include "pipeline/protocol/leave_one_out.h"

#include "calib/work/error.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/evaluate/held_out_subject.h"
#include "pipeline/line/line.h"
#include "pipeline/protocol/view_subset.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/stage_store.h"
#include "pipeline/workspace/work_folder.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Views of one judgement after those of the others, mode by mode.
void append(Evaluation& all, Evaluation one) {
    if (all.modes.empty()) {
        all = std::move(one);
        return;
    }
    for (std::size_t m = 0; m < all.modes.size(); ++m) {
        all.modes[m].views.insert(all.modes[m].views.end(), one.modes[m].views.begin(),
                                  one.modes[m].views.end());
    }
}

class LeavingOneOut {
 public:
    LeavingOneOut(const ConfigDocument& document, const std::vector<RenderMode>& modes,
                  Exposures exposures, const fs::path& folder, int threads, Progress& progress)
        : document_(document),
          options_{
              .modes = modes, .ghost_energy = false, .timed_frames = 1, .exposures = exposures},
          folder_(folder),
          threads_(threads),
          progress_(progress) {}

    LeaveOneOut run(bool remove_depth) {
        LeaveOneOut result;
        const WorkspaceLayout whole = build("whole", "[]");
        const PosedPhotographs all =
            read_posed_photographs(whole.stage_folder("poses") / "pinhole");
        result.photographs = view_names(all.capture);
        if (result.photographs.size() < 3) {
            throw Error(ErrorKind::kDegenerateCapture, "E-EVAL-FEW",
                        "fewer than three photographs have a place: none can be left out",
                        "take more photographs");
        }
        const Lumigraph lumigraph = read(whole);
        const EvaluationOptions options = judging_subject(options_, whole);
        for (const std::string& name : result.photographs) {
            append(result.depth_kept, judge_with_depth_kept(lumigraph, all, name, options));
        }
        if (!remove_depth) return result;
        for (std::size_t i = 0; i < result.photographs.size(); ++i) {
            progress_.note("leaving out " + result.photographs[i]);
            append(result.depth_removed,
                   judge_without(result.photographs[i], "without-" + std::to_string(i + 1)));
        }
        return result;
    }

 private:
    /// Returns where the package lies.
    [[nodiscard]] WorkspaceLayout build(const std::string& name,
                                        const std::string& hold_out) const {
        const BuildConfig config = document_.build_config_with(
            {{"evaluate.hold_out_every", "0"}, {"evaluate.hold_out", hold_out}});
        const Workspace workspace(WorkspaceLayout(folder_ / name, config.name));
        StageStore store(folder_ / "store");
        static_cast<void>(run_line(config, workspace, "pack", threads_, progress_, &store));
        return workspace;
    }

    [[nodiscard]] Lumigraph read(const WorkspaceLayout& workspace) const {
        return read_package(workspace.package_folder(), {}, options_.exposures);
    }

    [[nodiscard]] Evaluation judge(const Lumigraph& lumigraph, const PosedPhotographs& held_out,
                                   const EvaluationOptions& options) const {
        return evaluate_held_out(
            lumigraph, held_out, options, [](RenderMode, const JudgedView&) {}, progress_);
    }

    [[nodiscard]] Evaluation judge_with_depth_kept(const Lumigraph& whole,
                                                   const PosedPhotographs& all,
                                                   const std::string& name,
                                                   const EvaluationOptions& options) const {
        std::vector<int> others;
        for (std::size_t i = 0; i < whole.views.size(); ++i) {
            if (whole.views[i].name != name) others.push_back(static_cast<int>(i));
        }
        return judge(only_these_views(whole, others, document_.build_config_with({}).mesh),
                     only_views(all, {name}), options);
    }

    [[nodiscard]] Evaluation judge_without(const std::string& name,
                                           const std::string& folder) const {
        const WorkspaceLayout workspace = build(folder, "[" + literal_of_text(name) + "]");
        return judge(read(workspace), held_out_photographs(workspace, threads_),
                     judging_subject(options_, workspace));
    }

    const ConfigDocument& document_;
    EvaluationOptions options_;
    fs::path folder_;
    int threads_;
    Progress& progress_;
};

}  // namespace

LeaveOneOut leave_one_out(const ConfigDocument& document, const std::vector<RenderMode>& modes,
                          Exposures exposures, bool remove_depth, const fs::path& folder,
                          int threads, Progress& progress) {
    const WorkFolder held(folder, [](const fs::path& of_early_version) {
        return is_record_of_lumi(of_early_version / "leave-one-out.json") ||
               holds_workspace(of_early_version);
    });
    return LeavingOneOut(document, modes, exposures, folder, threads, progress).run(remove_depth);
}

}  // namespace lumi
