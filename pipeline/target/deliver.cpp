#include "pipeline/target/deliver.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/error.h"
#include "calib/work/whole_folder.h"
#include "pipeline/chart/reference_photographs.h"
#include "pipeline/line/line.h"
#include "pipeline/target/candidates.h"
#include "pipeline/workspace/folder_size.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Makes packages in one workspace, one after the other.
class Delivering {
 public:
    Delivering(const Wish& wish, const ChartResult& chart, const Workspace& workspace, int threads,
               Progress& progress)
        : wish_(wish),
          chart_(chart),
          workspace_(workspace),
          threads_(threads),
          progress_(progress) {}

    Delivery deliver_best() {
        std::optional<Delivery> nearest;
        int tried = 0;
        for (const ChartPoint& point : candidates_for(wish_, points_of(chart_))) {
            if (tried++ == kMaxDeliveries) break;
            Delivery delivery = make(point);
            if (meets(wish_, delivery.delivered)) return delivery;
            progress_.note(point.label + " comes to " + figure_text(wish_, delivery.delivered));
            const bool is_nearer = !nearest || shortfall(wish_, delivery.delivered) <
                                                   shortfall(wish_, nearest->delivered);
            if (is_nearer) nearest = std::move(delivery);
        }
        return make(nearest->chosen);
    }

 private:
    Delivery make(const ChartPoint& point) {
        progress_.note("building " + point.label);
        const Variant& variant = chart_.sweep.variants[point.variant];
        const std::vector<FinishedStage> stages =
            run_line(variant.config, workspace_, "pack", threads_, progress_);
        Delivery delivery{wish_,
                          point,
                          {},
                          achievement_of(point),
                          measure(point.mode),
                          placed_photographs(stages).value_or(PlacedPhotographs{})};
        for (const FinishedStage& stage : stages) delivery.delivered.build_s += stage.cost.wall_s;
        for (std::size_t i = 0; i < chart_.sweep.axes.size(); ++i) {
            const SweepAxis& axis = chart_.sweep.axes[i];
            delivery.settings.push_back(axis.setting + " = " + axis.values[variant.choice[i]]);
        }
        return delivery;
    }

    [[nodiscard]] Achievement measure(RenderMode mode) const {
        const WholeFolder scratch(workspace_.folder() / "reference");
        Evaluation evaluation = evaluate_held_out(
            read_package(workspace_.package_folder()),
            reference_photographs(workspace_, chart_.reference_copies, scratch.staging(), threads_,
                                  progress_),
            {.modes = {mode}, .ghost_energy = false}, [](RenderMode, const JudgedView&) {},
            progress_);
        std::vector<ViewScore>& views = evaluation.modes.front().views;
        std::erase_if(views, [&](const ViewScore& view) {
            return std::find(chart_.shared_views.begin(), chart_.shared_views.end(), view.name) ==
                   chart_.shared_views.end();
        });
        const ViewScore mean = mean_score(views);
        return {mean.ms > 0.0 ? 1000.0 / mean.ms : 0.0, mean.psnr_db,
                folder_mib(workspace_.package_folder()), 0.0};
    }

    const Wish& wish_;
    const ChartResult& chart_;
    const Workspace& workspace_;
    int threads_;
    Progress& progress_;
};

Json achievement_json(const Achievement& achievement) {
    return Json{{"frames_per_second", achievement.frames_per_second},
                {"psnr_db", achievement.psnr_db},
                {"package_mib", achievement.package_mib},
                {"build_s", achievement.build_s}};
}

}  // namespace

Delivery deliver(const Wish& wish, const ChartResult& chart, const Workspace& workspace,
                 int threads, Progress& progress) {
    return Delivering(wish, chart, workspace, threads, progress).deliver_best();
}

Json delivery_json(const Delivery& delivery) {
    return Json{{"wish", delivery.wish.text},
                {"is_met", meets(delivery.wish, delivery.delivered)},
                {"settings", delivery.settings},
                {"mode", name_of(delivery.chosen.mode)},
                {"promised", achievement_json(delivery.promised)},
                {"delivered", achievement_json(delivery.delivered)}};
}

}  // namespace lumi
