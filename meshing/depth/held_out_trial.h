#pragma once

#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth/depth_choice.h"
#include "meshing/depth/depth_scene.h"

namespace lumi {

/// A view with fewer points is not asked.
constexpr std::size_t kMinTrialPoints = 40;

/// What one rung got wrong on the sampled views.
struct Trial {
    RungLoss loss;
    /// Of the photographs kept back (photograph_loss.h), view by view in the order of the sample;
    /// maybe of fewer views.
    std::vector<double> tiles;
};

/// Asks rungs of the ladder for what they were not told: points of a view, and the photograph of a
/// neighbour. What is asked is what would be delivered: confirmed by the other neighbours, and
/// filled. Four views far apart are sampled, two where photographs are compared; pictures of 600
/// pixels and more are asked at half their size, at which surfaces are as wrong, in a quarter of
/// the time.
class HeldOutTrial {
 public:
    /// `masks`: of the views, as from scene_masks. The scene must outlive the trial.
    HeldOutTrial(const DepthScene& scene, const std::vector<GrayImage>& masks, int threads);

    /// False when no view has enough points.
    [[nodiscard]] bool is_possible() const { return !views_.empty(); }

    /// Throws Interrupted like all work.
    [[nodiscard]] Trial of(const std::string& model, const Progress& progress) const;

 private:
    const DepthScene& scene_;
    const std::vector<GrayImage>& masks_;
    int threads_;
    std::vector<int> views_;
};

}  // namespace lumi
