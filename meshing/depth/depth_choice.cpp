#include "meshing/depth/depth_choice.h"

#include <algorithm>

#include "meshing/depth/held_out_trial.h"
#include "meshing/depth/photograph_loss.h"

namespace lumi {
namespace {

std::string with_two_digits(double value) {
    const std::string text = std::to_string(value);
    return text.substr(0, text.find('.') + 3);
}

/// Climbs from rung to rung.
class Climb {
 public:
    Climb(const HeldOutTrial& trial, const Progress& progress)
        : trial_(trial), progress_(progress) {}

    DepthChoice run(const std::vector<std::string>& rungs) {
        for (const std::string& rung : rungs) {
            Trial next = trial_.of(rung, progress_);
            choice_.losses.push_back(next.loss);
            // One rung may fail where the next succeeds: pairs that cannot be rectified, points too
            // few to fill between. All are asked.
            if (choice_.model.empty() || is_better(next)) {
                choice_.model = rung;
                accepted_ = std::move(next);
            }
            if (accepted_.loss.p95_px < kEnoughPx) {
                choice_.explanation = choice_.model + ": 95 % of the points kept back lie within " +
                                      with_two_digits(accepted_.loss.p95_px) + " px of it";
                return choice_;
            }
        }
        choice_.explanation =
            choice_.model + ": " + evidence_of(accepted_.loss) +
            (choice_.model == rungs.back() ? ", clearly closer than the rungs below"
                                           : ", and no rung above it is clearly closer");
        return choice_;
    }

 private:
    static constexpr double kEnoughPx = 1.0;

    [[nodiscard]] static std::string evidence_of(const RungLoss& loss) {
        if (loss.photograph > 0) {
            return "predicts photographs kept back to " + with_two_digits(loss.photograph) +
                   " grey levels";
        }
        return "off by " + with_two_digits(loss.mean_px) + " px at points kept back";
    }

    /// Points lie on texture, where any rung does well: between them the photographs tell.
    [[nodiscard]] bool is_better(const Trial& next) const {
        if (!next.tiles.empty()) return is_clearly_closer(next.tiles, accepted_.tiles);
        return next.loss.mean_px +
                   std::max(next.loss.standard_error_px, accepted_.loss.standard_error_px) <
               accepted_.loss.mean_px;
    }

    const HeldOutTrial& trial_;
    const Progress& progress_;
    DepthChoice choice_;
    Trial accepted_;
};

}  // namespace

DepthChoice choose_depth_model(const DepthScene& scene, const std::vector<GrayImage>& masks,
                               const std::string& highest, int threads, Progress& progress) {
    const HeldOutTrial trial(scene, masks, threads);
    std::vector<std::string> rungs = depth_model_names();
    rungs.erase(std::find(rungs.begin(), rungs.end(), highest) + 1, rungs.end());
    if (!trial.is_possible()) {
        // Nothing could show that more than the sweep is worth its time.
        const std::string untried = highest == "patch_match" ? "sweep" : highest;
        return {untried,
                untried + ": no view has " + std::to_string(kMinTrialPoints) +
                    " scene points, by which a cheaper model could be judged",
                {}};
    }
    progress.begin("depth: choosing a model", 0);
    return Climb(trial, progress).run(rungs);
}

}  // namespace lumi
