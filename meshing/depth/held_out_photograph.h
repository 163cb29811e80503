#pragma once

#include <map>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// Views whose photographs can be kept back, to be asked in this order: those that others surround,
/// as a drawing's eye is surrounded, and far apart. Three, so that one that is misplaced does not
/// decide, and four of a larger scene.
[[nodiscard]] std::vector<int> photographs_to_keep_back(const DepthScene& scene);

/// One photograph that depth is found without, to be predicted from the depth of its neighbours.
///
/// What is asked of a rung is what it would deliver: confirmed by the other neighbours, and filled.
/// Pictures of 600 pixels and more are asked at half their size, at which surfaces are as wrong, in
/// a quarter of the time. What one rung found the next begins with, where it would.
class HeldOutPhotograph {
 public:
    /// `masks`: of the views, as from scene_masks. The scene must outlive the trial.
    HeldOutPhotograph(const DepthScene& scene, const std::vector<GrayImage>& masks, int kept_back);

    /// How far the photograph is from its prediction (photograph_loss.h). Throws Interrupted like
    /// all work.
    [[nodiscard]] std::vector<double> loss(const std::string& model, int threads,
                                           const Progress& progress);

 private:
    void add(int view);
    void link(std::size_t member);
    [[nodiscard]] const std::vector<DepthEstimate>& first_estimates(const DepthModel& model,
                                                                    int threads,
                                                                    const Progress& progress);
    [[nodiscard]] std::vector<DepthEstimate> refined(const DepthModel& model,
                                                     std::vector<DepthEstimate> estimates,
                                                     int threads, const Progress& progress) const;
    [[nodiscard]] std::vector<DepthMap> finished(const std::vector<DepthEstimate>& estimates,
                                                 int threads, const Progress& progress) const;

    const DepthScene& source_;
    const std::vector<GrayImage>& source_masks_;
    int kept_back_;
    int predictors_ = 0;  ///< Come first; behind them, what they are compared with.
    DepthScene scene_;
    std::vector<GrayImage> masks_;
    std::vector<int> members_;  ///< Of the source scene, as they lie in `scene_`.
    std::map<std::string, std::vector<DepthEstimate>> first_estimates_;  ///< By the rung.
};

}  // namespace lumi
