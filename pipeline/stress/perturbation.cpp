#include "pipeline/stress/perturbation.h"

namespace lumi {
namespace {

/// The camera mesh goes with the cameras: none is built.
template <Lumigraph (*kPerturb)(const Lumigraph&, double, std::uint64_t)>
Lumigraph with_its_mesh(const Lumigraph& lumigraph, double strength, std::uint64_t seed,
                        const CameraMeshOptions& /*mesh_options*/) {
    return kPerturb(lumigraph, strength, seed);
}

}  // namespace

const std::vector<Perturbation>& known_perturbations() {
    static const std::vector<Perturbation> perturbations{
        {"pose_rotation_deg",
         "rotation of the poses (degrees)",
         {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0},
         &with_its_mesh<with_turned_poses>},
        {"pose_position_percent",
         "place of the cameras (% of their spacing)",
         {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0},
         &with_its_mesh<with_moved_poses>},
        {"focal_length_percent",
         "focal length (% too long)",
         {0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0},
         &with_its_mesh<with_longer_focal_length>},
        {"depth_percent",
         "depth (% noise)",
         {0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0},
         &with_its_mesh<with_noisy_depth>},
        {"exposure_ev",
         "exposure (stops)",
         {0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0},
         &with_its_mesh<with_other_exposure>},
        {"blur_px",
         "sharpness (blur in pixels)",
         {0.3, 0.5, 1.0, 2.0, 4.0, 8.0},
         &with_its_mesh<with_blurred_photographs>},
        {"views_dropped_percent",
         "views dropped (%)",
         {10.0, 20.0, 35.0, 50.0, 65.0, 80.0, 90.0},
         &with_views_dropped}};
    return perturbations;
}

std::string words_of_perturbation(const std::string& perturbation) {
    for (const Perturbation& known : known_perturbations()) {
        if (known.name == perturbation) return known.words;
    }
    return perturbation;
}

}  // namespace lumi
