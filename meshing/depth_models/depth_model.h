#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "meshing/depth_scene/depth_estimate.h"
#include "meshing/depth_scene/depth_scene.h"

namespace lumi {

/// One rung of the ladder of depth models: plane, sparse, sweep ... Estimates of different views
/// are independent, and may be asked for from several threads at once.
class DepthModel {
 public:
    virtual ~DepthModel() = default;
    [[nodiscard]] virtual DepthEstimate estimate(const DepthScene& scene, int view_index) const = 0;

    /// Name of the rung whose estimates `estimate` makes: what that rung found need not be found
    /// again.
    [[nodiscard]] virtual std::string begins_as() const = 0;
    /// How often `refine` follows `estimate`.
    [[nodiscard]] virtual int refinements() const { return 0; }
    /// A better estimate, made with what all views said in the round before.
    [[nodiscard]] virtual DepthEstimate refine(const DepthScene& scene,
                                               const std::vector<DepthEstimate>& before,
                                               int view_index) const;
};

/// The rungs by name, cheapest first: "plane", "slanted_plane", "sparse", "sparse_fill",
/// "pair_stereo", "sweep", "refined_sweep" (PatchMatch where the sweep is unsure), "patch_match"
/// (everywhere). A rung that compares photographs gives way to
/// "sparse_fill" in a view without parallax to any neighbour.
[[nodiscard]] const std::vector<std::string>& depth_model_names();
/// Of these names: true for those that compare photographs, false for those that know points alone.
[[nodiscard]] bool compares_photographs(const std::string& name);

[[nodiscard]] std::unique_ptr<DepthModel> depth_model_named(const std::string& name);

/// Depth maps made elsewhere of the scene's own pictures (imported_depth.h), from a file of each of
/// its views.
[[nodiscard]] std::unique_ptr<DepthModel> imported_depth_model(
    std::vector<std::filesystem::path> files, double png_unit);

/// What a binary volume of the scene looks like from each view (volume_depth.h). Throws Error
/// (E-VOLUME-...).
[[nodiscard]] std::unique_ptr<DepthModel> volume_depth_model(const std::filesystem::path& file,
                                                             double threshold);

/// What a triangle mesh of the scene looks like from each view (mesh_depth.h). Throws Error
/// (E-GEOMETRY-...).
[[nodiscard]] std::unique_ptr<DepthModel> mesh_depth_model(const std::filesystem::path& file);

}  // namespace lumi
