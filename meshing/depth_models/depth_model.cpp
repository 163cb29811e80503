#include "meshing/depth_models/depth_model.h"

#include <algorithm>
#include <cassert>

#include "meshing/depth_models/imported_depth.h"
#include "meshing/depth_models/multi_view_sweep.h"
#include "meshing/depth_models/pair_stereo.h"
#include "meshing/depth_models/patch_match.h"
#include "meshing/depth_models/plane_depth.h"
#include "meshing/depth_models/sparse_depth.h"
#include "meshing/geometry/mesh_depth.h"
#include "meshing/geometry/volume_depth.h"

namespace lumi {
namespace {

const DepthView& view_of(const DepthScene& scene, int view_index) {
    return scene.views[static_cast<std::size_t>(view_index)];
}

/// Of geometry made elsewhere.
DepthEstimate exact(DepthMap map, const std::string& model) {
    return {.map = std::move(map), .model = model, .is_exact = true};
}

class ImportedModel final : public DepthModel {
 public:
    ImportedModel(std::vector<std::filesystem::path> files, double png_unit)
        : files_(std::move(files)), png_unit_(png_unit) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        const auto& file = files_[static_cast<std::size_t>(view_index)];
        return exact(imported_depth(view_of(scene, view_index), file, png_unit_), "imported");
    }
    [[nodiscard]] std::string begins_as() const override { return "imported"; }

 private:
    std::vector<std::filesystem::path> files_;
    double png_unit_;
};

class MeshModel final : public DepthModel {
 public:
    explicit MeshModel(TriangleMesh mesh) : mesh_(std::move(mesh)) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        return exact(mesh_depth(view_of(scene, view_index), mesh_), "mesh");
    }
    [[nodiscard]] std::string begins_as() const override { return "mesh"; }

 private:
    TriangleMesh mesh_;
};

class VolumeModel final : public DepthModel {
 public:
    explicit VolumeModel(BinaryVolume volume) : caster_(std::move(volume)) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        return exact(caster_.depth(view_of(scene, view_index)), "volume");
    }
    [[nodiscard]] std::string begins_as() const override { return "volume"; }

 private:
    VolumeCaster caster_;
};

/// A rung that looks at one view and its points alone.
class SingleViewModel final : public DepthModel {
 public:
    using Function = DepthMap (*)(const DepthView&);
    SingleViewModel(std::string name, Function function)
        : name_(std::move(name)), function_(function) {}
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        return {.map = function_(view_of(scene, view_index)), .model = name_, .is_complete = true};
    }
    [[nodiscard]] std::string begins_as() const override { return name_; }

 private:
    std::string name_;
    Function function_;
};

DepthEstimate without_parallax(const DepthScene& scene, int view_index) {
    return {.map = filled_sparse_depth(view_of(scene, view_index)),
            .model = "sparse_fill",
            .is_complete = true};
}

class PairStereoModel final : public DepthModel {
 public:
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        if (view_of(scene, view_index).disparity_px_per_inverse_depth <= 0 ||
            rectifiable_pairs(scene, view_index) == 0) {
            return without_parallax(scene, view_index);
        }
        return {.map = pair_stereo(scene, view_index),
                .model = "pair_stereo",
                .needs_confirmation = true};
    }
    [[nodiscard]] std::string begins_as() const override { return "pair_stereo"; }
};

class SweepModel : public DepthModel {
 public:
    [[nodiscard]] DepthEstimate estimate(const DepthScene& scene, int view_index) const override {
        if (view_of(scene, view_index).disparity_px_per_inverse_depth <= 0) {
            return without_parallax(scene, view_index);
        }
        SweepMemory memory = pool_.take();
        DepthEstimate estimate{.map = multi_view_sweep(scene, view_index, memory),
                               .model = "sweep",
                               .needs_confirmation = true};
        pool_.give_back(std::move(memory));
        return estimate;
    }
    [[nodiscard]] std::string begins_as() const override { return "sweep"; }

 private:
    mutable SweepMemoryPool pool_;
};

class PatchMatchModel final : public SweepModel {
 public:
    PatchMatchModel(std::string name, bool only_where_unsure) : name_(std::move(name)) {
        options_.only_where_unsure = only_where_unsure;
    }
    [[nodiscard]] int refinements() const override { return 1; }
    [[nodiscard]] DepthEstimate refine(const DepthScene& scene,
                                       const std::vector<DepthEstimate>& before,
                                       int view_index) const override {
        const DepthEstimate& own = before[static_cast<std::size_t>(view_index)];
        if (!own.needs_confirmation) return own;
        return {.map = patch_match(scene, before, view_index, options_),
                .model = name_,
                .needs_confirmation = true};
    }

 private:
    std::string name_;
    PatchMatchOptions options_;
};

}  // namespace

DepthEstimate DepthModel::refine(const DepthScene&, const std::vector<DepthEstimate>& before,
                                 int view_index) const {
    return before[static_cast<std::size_t>(view_index)];
}

const std::vector<std::string>& depth_model_names() {
    static const std::vector<std::string> names{"plane",         "slanted_plane", "sparse",
                                                "sparse_fill",   "pair_stereo",   "sweep",
                                                "refined_sweep", "patch_match"};
    return names;
}

bool compares_photographs(const std::string& name) {
    return name == "pair_stereo" || name == "sweep" || name == "refined_sweep" ||
           name == "patch_match";
}

std::unique_ptr<DepthModel> depth_model_named(const std::string& name) {
    if (name == "plane") return std::make_unique<SingleViewModel>(name, plane_depth);
    if (name == "slanted_plane") {
        return std::make_unique<SingleViewModel>(name, slanted_plane_depth);
    }
    if (name == "sparse") return std::make_unique<SingleViewModel>(name, sparse_depth);
    if (name == "sparse_fill") return std::make_unique<SingleViewModel>(name, filled_sparse_depth);
    if (name == "pair_stereo") return std::make_unique<PairStereoModel>();
    if (name == "sweep") return std::make_unique<SweepModel>();
    assert(name == "refined_sweep" || name == "patch_match");
    return std::make_unique<PatchMatchModel>(name, name == "refined_sweep");
}

std::unique_ptr<DepthModel> imported_depth_model(std::vector<std::filesystem::path> files,
                                                 double png_unit) {
    return std::make_unique<ImportedModel>(std::move(files), png_unit);
}

std::unique_ptr<DepthModel> mesh_depth_model(const std::filesystem::path& file) {
    return std::make_unique<MeshModel>(read_triangle_mesh(file));
}

std::unique_ptr<DepthModel> volume_depth_model(const std::filesystem::path& file,
                                               double threshold) {
    return std::make_unique<VolumeModel>(read_binary_volume(file, threshold));
}

}  // namespace lumi
