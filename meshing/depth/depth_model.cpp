#include "meshing/depth/depth_model.h"

#include <cassert>

#include "meshing/depth/imported_depth.h"
#include "meshing/depth/multi_view_sweep.h"
#include "meshing/depth/sparse_depth.h"

namespace lumi {
namespace {

class ImportedModel final : public DepthModel {
 public:
    explicit ImportedModel(std::filesystem::path folder) : folder_(std::move(folder)) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
        return {imported_depth(view, folder_), "imported", false};
    }

 private:
    std::filesystem::path folder_;
};

class SparseModel final : public DepthModel {
 public:
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        return {sparse_depth(scene.views[static_cast<std::size_t>(view_index)]), "sparse", false};
    }
};

class SweepModel final : public DepthModel {
 public:
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
        // Without parallax to any neighbour there is nothing to sweep.
        if (view.disparity_px_per_inverse_depth <= 0) {
            return SparseModel().estimate(scene, view_index);
        }
        return {multi_view_sweep(scene, view_index), "sweep", true};
    }
};

}  // namespace

std::unique_ptr<DepthModel> make_depth_model(const DepthOptions& options) {
    if (!options.import_folder.empty()) {
        return std::make_unique<ImportedModel>(options.import_folder);
    }
    if (options.model == "sparse") return std::make_unique<SparseModel>();
    assert(options.model == "sweep");
    return std::make_unique<SweepModel>();
}

}  // namespace lumi
