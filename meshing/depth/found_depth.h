#pragma once

#include <memory>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth/depth_stage.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// Depth of the scene's views by one model, from first estimates to maps that can be drawn: views
/// are matched and refined, confirm each other, and what remains unknown is filled.
///
/// `masks` (view_mask.h): one a view. `result` says how much memory may be taken, and takes maps,
/// evidence, the time that asking the photographs took, and the warning.
void find_depth(const DepthScene& scene, const std::vector<GrayImage>& masks,
                std::unique_ptr<DepthModel> model, Progress& progress, DepthResult& result);

}  // namespace lumi
