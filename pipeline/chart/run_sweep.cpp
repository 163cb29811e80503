#include "pipeline/chart/run_sweep.h"

#include <algorithm>
#include <set>

#include "calib/work/content_hash.h"
#include "calib/work/error_of_exception.h"
#include "calib/work/printable.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_folder.h"
#include "pipeline/chart/chart_folder.h"
#include "pipeline/chart/measurement_cache.h"
#include "pipeline/chart/reference_photographs.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/line/line.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/workspace/folder_size.h"
#include "pipeline/workspace/stage_store.h"
#include "render/gl/capabilities.h"
#include "render/gl/headless_context.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

WorkspaceLayout variant_layout(const Variant& variant, const fs::path& folder, int repeat) {
    std::string name = sha256_hex(variant.config.resolved_toml).substr(0, 16);
    if (repeat > 0) name += "-repeat-" + std::to_string(repeat);
    return {folder / "variants" / name, variant.config.name};
}

/// What will draw.
std::string opengl_at_hand() {
    const HeadlessContext context;
    return query_capabilities().description;
}

/// One run over a sweep.
class SweepRun {
 public:
    SweepRun(const Sweep& sweep, const fs::path& folder, int threads, Progress& progress,
             const IsEnough& is_enough)
        : folder_(folder), threads_(threads), progress_(progress), is_enough_(is_enough) {
        result_.sweep = sweep;
        result_.variants.resize(sweep.variants.size());
        for (int repeat = 0; repeat < sweep.repeats; ++repeat)
            stores_.emplace_back(folder / ("store-" + std::to_string(repeat)));
    }

    ChartResult run() {
        const Stopwatch stopwatch;
        for (std::size_t i = 0; i < variants().size(); ++i) copy_photographs(i);
        choose_reference();
        for (std::size_t i = 0; i < variants().size(); ++i) {
            build(i);
            measure(i);
            if (is_enough_ && is_enough_(result_.variants[i])) forget_after(i);
        }
        keep_shared_views();
        result_.wall_s = stopwatch.elapsed().wall_s;
        return std::move(result_);
    }

 private:
    [[nodiscard]] const std::vector<Variant>& variants() const { return result_.sweep.variants; }

    /// A variant's error is part of what a chart shows; the user and a full disk end it.
    template <class Work>
    void attempt(std::size_t index, const Work& work) {
        try {
            work();
        } catch (const std::exception& exception) {
            const std::optional<Error> error = error_of_exception(exception);
            if (!error || ends_all_work(*error)) throw;
            result_.variants[index].failure = printable(failure_text(*error));
            progress_.note(variants()[index].label + ": " + result_.variants[index].failure);
            first_error_ = first_error_.value_or(*error);
        }
    }

    /// No variant was made: what ended the first, which a build tells more of.
    [[noreturn]] void refuse_all() const {
        throw Error(first_error_->kind(), first_error_->code(), first_error_->what(),
                    first_error_->advice() +
                        "; `lumi build` of the same configuration writes a report of it");
    }

    /// All are compared with the largest photographs, which must be there before the first is.
    void copy_photographs(std::size_t index) {
        attempt(index, [&] {
            const Workspace workspace(variant_layout(variants()[index], folder_, 0));
            for (const FinishedStage& stage :
                 run_line(variants()[index].config, workspace, "ingest", threads_, progress_,
                          &stores_.front())) {
                if (stage.was_run) result_.work.done_cpu_s += stage.cost.cpu_s;
            }
        });
    }

    void build(std::size_t index) {
        if (!result_.variants[index].failure.empty()) return;
        progress_.note("variant " + std::to_string(index + 1) + " of " +
                       std::to_string(variants().size()) + ": " + variants()[index].label);
        attempt(index, [&] {
            std::string package;
            for (int repeat = 0; repeat < result_.sweep.repeats; ++repeat) {
                const std::string made = build_once(index, repeat);
                if (repeat == 0) package = made;
                if (made != package) result_.variants[index].repeats_are_equal = false;
            }
        });
    }

    /// Returns what tells the package from others.
    std::string build_once(std::size_t index, int repeat) {
        const Variant& variant = variants()[index];
        MeasuredVariant& measured = result_.variants[index];
        const Workspace workspace(variant_layout(variant, folder_, repeat));
        StageStore& store = stores_[static_cast<std::size_t>(repeat)];
        const std::vector<FinishedStage> stages =
            run_line(variant.config, workspace, "pack", threads_, progress_, &store);
        if (measured.stages.empty()) measured.stages.resize(stages.size());
        for (std::size_t i = 0; i < stages.size(); ++i) {
            StageTimes& times = measured.stages[i];
            times.stage = stages[i].name;
            times.cpu_s.push_back(stages[i].cost.cpu_s);
            times.wall_s.push_back(stages[i].cost.wall_s);
            if (repeat == 0) {
                if (stages[i].was_run) result_.work.done_cpu_s += stages[i].cost.cpu_s;
                result_.work.alone_cpu_s +=
                    stages[i].cost.cpu_s * static_cast<double>(result_.sweep.modes.size());
            }
        }
        measured.package_mib = folder_mib(workspace.package_folder());
        return package_sha256(workspace);
    }

    /// The working copies of the variant whose photographs are largest.
    void choose_reference() {
        double most_pixels = 0.0;
        for (std::size_t i = 0; i < variants().size(); ++i) {
            if (!result_.variants[i].failure.empty()) continue;
            std::vector<Photograph> copies =
                read_photograph_list(
                    variant_layout(variants()[i], folder_, 0).stage_folder("ingest"))
                    .photographs;
            double pixels = 0.0;
            for (const Photograph& copy : copies) {
                pixels += static_cast<double>(copy.width_px) * copy.height_px;
            }
            if (pixels <= most_pixels) continue;
            most_pixels = pixels;
            result_.reference_copies = std::move(copies);
        }
        if (result_.reference_copies.empty()) refuse_all();
        for (const Photograph& copy : result_.reference_copies) {
            result_.reference_width_px = std::max(result_.reference_width_px, copy.width_px);
        }
    }

    void measure(std::size_t index) {
        if (!result_.variants[index].failure.empty()) return;
        attempt(index, [&] {
            const WorkspaceLayout workspace = variant_layout(variants()[index], folder_, 0);
            const std::string what = identity_of_measurement(workspace);
            std::vector<RenderMode> missing;
            for (const RenderMode mode : result_.sweep.modes) {
                if (!cache_.find(what, mode)) missing.push_back(mode);
            }
            if (!missing.empty()) measure_modes(workspace, what, missing);
            for (const RenderMode mode : result_.sweep.modes) {
                const Measurement measurement = cache_.find(what, mode).value();
                result_.work.alone_cpu_s += measurement.cpu_s;
                result_.gl_description = measurement.gl_description;
                result_.variants[index].scores.push_back(measurement.scores);
            }
        });
    }

    /// The package, and the photographs that it is compared with.
    [[nodiscard]] std::string identity_of_measurement(const WorkspaceLayout& workspace) const {
        std::string what = package_sha256(workspace);
        const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
        for (const Photograph& copy : result_.reference_copies) {
            if (std::binary_search(record.held_out.begin(), record.held_out.end(), copy.name)) {
                what += copy.name + sha256_hex_of_file(copy.picture_path);
            }
        }
        return what;
    }

    void measure_modes(const WorkspaceLayout& workspace, const std::string& what,
                       const std::vector<RenderMode>& modes) {
        const WholeFolder scratch(folder_ / "reference");
        const Stopwatch stopwatch;
        const PosedPhotographs held_out = reference_photographs(
            workspace, result_.reference_copies, scratch.staging(), threads_, progress_);
        const Evaluation evaluation = evaluate_held_out(
            read_package(workspace.package_folder()), held_out,
            {.modes = modes, .ghost_energy = false}, [](RenderMode, const JudgedView&) {},
            progress_);
        const double cpu_s = stopwatch.elapsed().cpu_s;
        result_.work.done_cpu_s += cpu_s;
        for (const ModeScores& scores : evaluation.modes) {
            cache_.keep(what, {scores, evaluation.gl_description,
                               cpu_s / static_cast<double>(modes.size())});
        }
    }

    /// The variants after this one were not needed: the sweep ends as if it had not had them.
    void forget_after(std::size_t index) {
        progress_.note(std::to_string(variants().size() - index - 1) +
                       " dearer variants are not needed");
        result_.variants.resize(index + 1);
        result_.sweep.variants.resize(index + 1);
    }

    /// Means are compared over the views that every variant can be judged by.
    void keep_shared_views() {
        std::optional<std::set<std::string>> shared;
        for (const MeasuredVariant& variant : result_.variants) {
            if (variant.scores.empty()) continue;
            std::set<std::string> names;
            for (const ViewScore& view : variant.scores.front().views) {
                if (!shared || shared->contains(view.name)) names.insert(view.name);
            }
            shared = std::move(names);
        }
        if (!shared) refuse_all();
        result_.shared_views.assign(shared->begin(), shared->end());
        for (MeasuredVariant& variant : result_.variants) {
            for (ModeScores& scores : variant.scores) {
                std::erase_if(scores.views,
                              [&](const ViewScore& view) { return !shared->contains(view.name); });
            }
        }
    }

    fs::path folder_;
    int threads_;
    Progress& progress_;
    const IsEnough& is_enough_;
    ChartResult result_;
    std::vector<StageStore> stores_;  ///< By repeats: these share nothing.
    MeasurementCache cache_{folder_ / "measurements", opengl_at_hand()};
    std::optional<Error> first_error_;
};

}  // namespace

ChartResult run_sweep(const Sweep& sweep, const fs::path& folder, int threads, Progress& progress,
                      const IsEnough& is_enough) {
    const WorkFolder held = take_chart_folder(folder);
    return SweepRun(sweep, folder, threads, progress, is_enough).run();
}

}  // namespace lumi
