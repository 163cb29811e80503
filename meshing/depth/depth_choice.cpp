#include "meshing/depth/depth_choice.h"

#include <algorithm>
#include <map>

#include "calib/work/formatted.h"
#include "meshing/depth/held_out_photograph.h"
#include "meshing/depth/held_out_points.h"
#include "meshing/depth/photograph_loss.h"

namespace lumi {
namespace {

/// A rung that is astray at a larger share of points misses some object: this much of them wrong
/// matches that agree with each other may be.
constexpr double kMostAstray = 0.005;

std::string with_two_digits(double value) { return formatted("%.2f", value); }

/// Photographs kept back, and what the rungs make of them as far as anybody asked.
class Race {
 public:
    Race(const DepthScene& scene, const std::vector<GrayImage>& masks, int threads,
         const Progress& progress)
        : threads_(threads), progress_(progress) {
        for (const int view : photographs_to_keep_back(scene)) {
            photographs_.emplace_back(scene, masks, view);
        }
    }

    [[nodiscard]] bool is_possible() const { return !photographs_.empty(); }

    /// True when `next` predicts the photographs clearly better than `current`.
    [[nodiscard]] bool is_won_by(const std::string& next, const std::string& current) {
        constexpr double kHardlyChance = 2.0;  // Standard errors.
        std::vector<double> of_next;
        std::vector<double> of_current;
        for (std::size_t k = 0; k < photographs_.size(); ++k) {
            append(tiles(current, k), of_current);
            append(tiles(next, k), of_next);
            if (is_clearly_closer(of_next, of_current, kHardlyChance)) return true;
        }
        return is_clearly_closer(of_next, of_current, 1.0);
    }

    /// Grey levels by which the photographs that were asked differ from what the rung predicts.
    [[nodiscard]] double gray_levels(const std::string& model) {
        std::vector<double> all;
        for (const std::vector<double>& tiles : tiles_[model]) append(tiles, all);
        return rms_of(all);
    }

 private:
    static void append(const std::vector<double>& tiles, std::vector<double>& all) {
        all.insert(all.end(), tiles.begin(), tiles.end());
    }

    const std::vector<double>& tiles(const std::string& model, std::size_t k) {
        std::vector<std::vector<double>>& known = tiles_[model];
        while (known.size() <= k) {
            known.push_back(photographs_[known.size()].loss(model, threads_, progress_));
        }
        return known[k];
    }

    int threads_;
    const Progress& progress_;
    std::vector<HeldOutPhotograph> photographs_;
    std::map<std::string, std::vector<std::vector<double>>> tiles_;  ///< One each photograph asked.
};

/// The lowest rung that the points alone show to be enough; empty when none is.
///
/// Of the points that agree with their surroundings next to none may be far from it: 5 % are more
/// than many an object has.
DepthChoice enough_by_points(const DepthScene& scene, const std::vector<std::string>& rungs,
                             int threads, const Progress& progress) {
    constexpr double kEnoughPx = 1.0;
    for (const std::string& rung : rungs) {
        if (compares_photographs(rung)) continue;
        const auto points = held_out_points(scene, rung, threads, progress);
        if (!points || points->p95_px >= kEnoughPx || points->astray_share > kMostAstray) continue;
        return {rung,
                rung + ": 95 % of the points kept back lie within " +
                    with_two_digits(points->p95_px) + " px of it",
                {}};
    }
    return {};
}

DepthChoice best_by_photographs(Race& race, const std::vector<std::string>& rungs) {
    DepthChoice choice{rungs.front(), "", {rungs.front()}};
    for (std::size_t i = 1; i < rungs.size(); ++i) {
        // One rung may fail where the next succeeds: pairs that cannot be rectified, points too few
        // to fill between. All are asked.
        if (race.is_won_by(rungs[i], choice.model)) choice.model = rungs[i];
        choice.compared.push_back(rungs[i]);
    }
    choice.explanation = choice.model + ": predicts photographs kept back to " +
                         with_two_digits(race.gray_levels(choice.model)) + " grey levels" +
                         (choice.model == rungs.back() ? ", clearly closer than the rungs below"
                                                       : ", and no rung above is clearly closer");
    return choice;
}

/// The sweep in place of a rung that knows points alone, where points kept back lie clearly nearer
/// to it. To keep photographs back thins a capture out, from which the sweep suffers most, and fine
/// texture differs as much a pixel beside as ten; points can be kept back without that.
DepthChoice contradicted_by_points(DepthChoice choice, const DepthScene& scene, int threads,
                                   const Progress& progress) {
    constexpr double kClearly = 2.0;
    if (compares_photographs(choice.model)) return choice;
    const auto of_rung = held_out_points(scene, choice.model, threads, progress);
    const auto of_sweep = held_out_points(scene, "sweep", threads, progress);
    if (!of_rung || !of_sweep) return choice;
    const bool is_nearer = kClearly * of_sweep->p95_px < of_rung->p95_px;
    const bool is_less_astray = of_rung->astray_share > kMostAstray &&
                                kClearly * of_sweep->astray_share < of_rung->astray_share;
    if (!is_nearer && !is_less_astray) return choice;
    choice.explanation =
        is_nearer ? "sweep: 95 % of the points kept back lie within " +
                        with_two_digits(of_sweep->p95_px) + " px of it, and within " +
                        with_two_digits(of_rung->p95_px) + " px of " + choice.model
                  : "sweep: it is astray at " + with_two_digits(100 * of_sweep->astray_share) +
                        " % of the points kept back, and " + choice.model + " at " +
                        with_two_digits(100 * of_rung->astray_share) + " %";
    choice.explanation += ", which predicts photographs kept back as well";
    choice.model = "sweep";
    return choice;
}

/// The sweep, refined where it is unsure; untried, since trials at half the size do not see what it
/// gains at full size.
DepthChoice refined(DepthChoice choice) {
    if (choice.model != "sweep") return choice;
    choice.model = "refined_sweep";
    choice.explanation += "; refined where it is unsure";
    return choice;
}

}  // namespace

DepthChoice choose_depth_model(const DepthScene& scene, const std::vector<GrayImage>& masks,
                               const std::string& highest, int threads, Progress& progress) {
    progress.begin("depth: choosing a model", 0);
    std::vector<std::string> rungs = depth_model_names();
    const bool refines = highest == "refined_sweep";
    rungs.erase(std::find(rungs.begin(), rungs.end(), refines ? "sweep" : highest) + 1,
                rungs.end());
    DepthChoice enough = enough_by_points(scene, rungs, threads, progress);
    if (!enough.model.empty()) return enough;
    Race race(scene, masks, threads, progress);
    const bool has_sweep = std::find(rungs.begin(), rungs.end(), "sweep") != rungs.end();
    if (race.is_possible()) {
        DepthChoice best = best_by_photographs(race, rungs);
        if (has_sweep) best = contradicted_by_points(std::move(best), scene, threads, progress);
        return refines ? refined(std::move(best)) : best;
    }
    // Nothing could show that more than the sweep is worth its time.
    const std::string untried = has_sweep ? "sweep" : highest;
    return {untried,
            untried + ": no view has two neighbours, by which its photograph could be predicted",
            {}};
}

}  // namespace lumi
