#pragma once

#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth_models/depth_model.h"

namespace lumi {

struct DepthChoice {
    std::string model;
    std::string explanation;            ///< One line: what was chosen, and why.
    std::vector<std::string> compared;  ///< Rungs whose photographs were predicted, in order.
};

/// The cheapest rung that is enough.
///
/// First the points alone are asked (held_out_points.h): a rung that knows nothing else is enough
/// when it puts 95 % of the points kept back within a pixel of disparity, and is astray at hardly
/// any that agree with those around them: the rest must not be one object. Rungs that compare
/// photographs are not judged so: points lie on texture, where any of them does well.
///
/// Then photographs kept back are predicted (held_out_photograph.h), and the choice climbs while
/// the next rung predicts them better by more than one standard error (Breiman et al. 1984, section
/// 3.4.3, applied rung by rung). One photograph after the other is asked, and none further once the
/// next rung leads by two standard errors (a race, Maron and Moore 1994). Before a rung is given up
/// all are asked: the tiles of a photograph that is not where it is said to be are all wrong
/// together. What is compared is what would be delivered, `masks` (scene_masks) included.
///
/// Where that ends with a rung that knows points alone, points are asked once more: the sweep is
/// taken if points kept back lie twice as near to it, or if it is astray at half as many.
///
/// With "refined_sweep" as `highest` the sweep is the last rung that is tried, and where it wins it
/// is refined, pixel by pixel where it is unsure.
///
/// Rungs above `highest` are not tried. Where no photograph can be kept back, `highest` is taken,
/// but not more than the sweep.
[[nodiscard]] DepthChoice choose_depth_model(const DepthScene& scene,
                                             const std::vector<GrayImage>& masks,
                                             const std::string& highest, int threads,
                                             Progress& progress);

}  // namespace lumi
