#include "pipeline/evaluate/depth_mesh_effort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "calib/work/mean.h"
#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

/// Octaves, the coarsest first.
constexpr std::array<double, 4> kMeshErrors_px{kNoisyDepthError_px, 0.8, 0.4, 0.2};
/// A wide one for noise, and the narrowest.
const std::vector<double> kMeshTolerances_px{12.0, kOcclusionTolerance_px};
/// A fifth of what viewers begin to see, as for blocks (depth_effort.cpp).
constexpr double kUnseenMeshLoss_db = 0.1;

/// What blocks share is asked, as for all else that photographs choose.
const RenderOptions kMeshesAlike{.smooth_silhouettes = false};

/// Of each picture.
using MeshLossesDb = std::vector<double>;

bool tells_noise(const LumigraphView& view) {
    return view.depth_mesh && is_of_noise(*view.depth_mesh, view.depth);
}

/// Asks the photographs.
class MeshQuestion {
 public:
    MeshQuestion(const Lumigraph& lumigraph, const Capture& capture,
                 const CameraMeshOptions& mesh_options, double tolerance_px, Progress& progress)
        : lumigraph_(lumigraph),
          capture_(capture),
          mesh_options_(mesh_options),
          tolerances_px_(tolerance_px == 0 ? kMeshTolerances_px : std::vector{tolerance_px}),
          progress_(progress) {}

    /// What is lost by meshes of these errors, each with the tolerance that suits it better.
    [[nodiscard]] std::map<double, MeshLossesDb> losses_by_error(
        const std::vector<double>& errors_px) {
        std::map<double, std::vector<MeshLossesDb>> by_tolerance;
        visit_kept_back(lumigraph_, capture_, mesh_options_,
                        "asking photographs how closely depth must be followed", progress_,
                        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
                            for (const double error_px : errors_px) {
                                remake_depth_meshes(others, error_px);
                                add_losses(others, pictures, by_tolerance[error_px]);
                            }
                        });
        std::map<double, MeshLossesDb> best;
        for (auto& [error_px, losses_db] : by_tolerance)
            best[error_px] =
                std::move(*std::min_element(losses_db.begin(), losses_db.end(),
                                            [](const MeshLossesDb& a, const MeshLossesDb& b) {
                                                return mean_of(a) < mean_of(b);
                                            }));
        return best;
    }

 private:
    /// Those of rounds before are used again where they are fine enough among these views.
    void remake_depth_meshes(Lumigraph& others, double error_px) {
        if (others.noisy_depth_error_px == error_px) return;
        others.noisy_depth_error_px = error_px;
        std::map<std::string, std::shared_ptr<const DepthMesh>>& made = made_by_error_[error_px];
        for (LumigraphView& view : others.views)
            if (tells_noise(view)) view.depth_mesh = made[view.name];
        QuietPart of_the_question(progress_);
        make_depth_meshes(others, 0, of_the_question);
        for (const LumigraphView& view : others.views) made[view.name] = view.depth_mesh;
    }

    /// For each tolerance.
    void add_losses(const Lumigraph& others, const std::vector<PicturedEye>& pictures,
                    std::vector<MeshLossesDb>& losses_db) const {
        losses_db.resize(tolerances_px_.size());
        OffscreenRenderer renderer(others);
        DrawingChoices drawing = others.drawing;
        for (std::size_t i = 0; i < tolerances_px_.size(); ++i) {
            progress_.throw_if_interrupted();
            drawing.occlusion_tolerance_px = tolerances_px_[i];
            renderer.choose(drawing);
            const DrawnPictures drawn = draw_pictures(renderer, pictures, kMeshesAlike);
            losses_db[i].insert(losses_db[i].end(), drawn.losses_db.begin(), drawn.losses_db.end());
        }
    }

    const Lumigraph& lumigraph_;
    const Capture& capture_;
    const CameraMeshOptions& mesh_options_;
    std::vector<double> tolerances_px_;
    Progress& progress_;
    /// Of views by their names.
    std::map<double, std::map<std::string, std::shared_ptr<const DepthMesh>>> made_by_error_;
};

}  // namespace

DepthMeshEffort sufficient_depth_mesh_effort(const Lumigraph& lumigraph, const Capture& capture,
                                             const CameraMeshOptions& mesh_options,
                                             double tolerance_px, Progress& progress) {
    if (std::none_of(lumigraph.views.begin(), lumigraph.views.end(), tells_noise)) return {};
    MeshQuestion question(lumigraph, capture, mesh_options, tolerance_px, progress);
    constexpr double kCoarsest_px = kMeshErrors_px.front();
    constexpr double kFinest_px = kMeshErrors_px.back();
    auto losses_db = question.losses_by_error({kCoarsest_px, kFinest_px});
    if (losses_db.empty()) return {};
    const MeshLossesDb finest = losses_db[kFinest_px];
    const Excess of_coarsest = excess_over(losses_db[kCoarsest_px], finest);
    DepthMeshEffort effort{.pictures = static_cast<int>(finest.size()),
                           .coarsest_lose_db = of_coarsest.mean,
                           .standard_error_db = of_coarsest.standard_error,
                           .loses_db = of_coarsest.mean};
    if (of_coarsest.mean <= std::max(kUnseenMeshLoss_db, of_coarsest.standard_error)) return effort;
    losses_db.merge(
        question.losses_by_error({kMeshErrors_px.begin() + 1, kMeshErrors_px.end() - 1}));
    for (const double error_px : kMeshErrors_px) {
        effort.noisy_error_px = error_px;
        effort.loses_db = excess_over(losses_db[error_px], finest).mean;
        if (effort.loses_db <= kUnseenMeshLoss_db) break;
    }
    return effort;
}

}  // namespace lumi
