#pragma once

#include <memory>
#include <string>

#include "meshing/depth/depth_scene.h"
#include "meshing/depth/depth_stage.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What one rung of the ladder says of one view.
struct DepthEstimate {
    DepthMap map;
    std::string model;  ///< Name of the rung that made it.
    /// True when `map.confidence` is a claim that other views must still confirm; false when it is
    /// final.
    bool needs_confirmation = false;
};

/// One rung of the ladder of depth models: plane, sparse, sweep ... Estimates of different views
/// are independent, and may be asked for from several threads at once.
class DepthModel {
 public:
    virtual ~DepthModel() = default;
    [[nodiscard]] virtual DepthEstimate estimate(const DepthScene& scene, int view_index) const = 0;
};

/// The model that the options name: imported depth when a folder is given, else `options.model`.
[[nodiscard]] std::unique_ptr<DepthModel> make_depth_model(const DepthOptions& options);

}  // namespace lumi
