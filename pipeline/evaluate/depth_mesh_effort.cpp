#include "pipeline/evaluate/depth_mesh_effort.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

#include "meshing/selection/one_standard_error.h"
#include "pipeline/evaluate/kept_back_rounds.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

/// Octaves, the coarsest first.
constexpr std::array<double, 4> kErrors_px{kNoisyDepthError_px, 0.8, 0.4, 0.2};
/// A wide one for noise, and the narrowest.
constexpr std::array<double, 2> kTolerances_px{12.0, kOcclusionTolerance_px};
/// A fifth of what viewers begin to see, as for blocks (depth_effort.cpp).
constexpr double kUnseenMeshLoss_db = 0.1;

/// What blocks share is asked, as for all else that photographs choose.
const RenderOptions kMeshesAlike{.smooth_silhouettes = false};

using LossesDb = std::vector<double>;

bool tells_noise(const LumigraphView& view) {
    return view.depth_mesh && is_of_noise(*view.depth_mesh, view.depth);
}

double sum(const LossesDb& losses_db) {
    return std::accumulate(losses_db.begin(), losses_db.end(), 0.0);
}

/// Asks the photographs.
class MeshQuestion {
 public:
    MeshQuestion(const Lumigraph& lumigraph, const Capture& capture,
                 const CameraMeshOptions& mesh_options, Progress& progress)
        : lumigraph_(lumigraph),
          capture_(capture),
          mesh_options_(mesh_options),
          progress_(progress) {}

    /// What each picture loses by meshes of this error, with the tolerance that suits them best.
    [[nodiscard]] LossesDb losses_db_of(double error_px) const {
        Lumigraph meshed = lumigraph_;
        meshed.noisy_depth_error_px = error_px;
        make_depth_meshes(meshed, 0, progress_);
        std::array<LossesDb, kTolerances_px.size()> losses_db;
        visit_kept_back(meshed, capture_, mesh_options_,
                        "asking photographs how closely depth must be followed", progress_,
                        [&](Lumigraph& others, const std::vector<PicturedEye>& pictures) {
                            for (std::size_t i = 0; i < kTolerances_px.size(); ++i) {
                                progress_.throw_if_interrupted();
                                others.occlusion_tolerance_px = kTolerances_px[i];
                                OffscreenRenderer renderer(others);
                                const DrawnPictures drawn =
                                    draw_pictures(renderer, pictures, kMeshesAlike);
                                losses_db[i].insert(losses_db[i].end(), drawn.losses_db.begin(),
                                                    drawn.losses_db.end());
                            }
                        });
        return *std::min_element(
            losses_db.begin(), losses_db.end(),
            [](const LossesDb& a, const LossesDb& b) { return sum(a) < sum(b); });
    }

 private:
    const Lumigraph& lumigraph_;
    const Capture& capture_;
    const CameraMeshOptions& mesh_options_;
    Progress& progress_;
};

}  // namespace

DepthMeshEffort sufficient_depth_mesh_effort(const Lumigraph& lumigraph, const Capture& capture,
                                             const CameraMeshOptions& mesh_options,
                                             Progress& progress) {
    if (std::none_of(lumigraph.views.begin(), lumigraph.views.end(), tells_noise)) return {};
    const MeshQuestion question(lumigraph, capture, mesh_options, progress);
    const LossesDb of_coarsest = question.losses_db_of(kErrors_px.front());
    if (of_coarsest.empty()) return {};
    const LossesDb of_finest = question.losses_db_of(kErrors_px.back());
    const Excess excess = excess_over(of_coarsest, of_finest);
    DepthMeshEffort effort{.pictures = static_cast<int>(of_coarsest.size()),
                           .coarsest_lose_db = excess.mean,
                           .standard_error_db = excess.standard_error,
                           .loses_db = excess.mean};
    if (excess.mean <= excess.standard_error) return effort;
    for (std::size_t i = 1; i < kErrors_px.size() && effort.loses_db > kUnseenMeshLoss_db; ++i) {
        const bool is_finest = i + 1 == kErrors_px.size();
        effort.noisy_error_px = kErrors_px[i];
        effort.loses_db =
            is_finest ? 0.0 : excess_over(question.losses_db_of(kErrors_px[i]), of_finest).mean;
    }
    return effort;
}

}  // namespace lumi
