#include "meshing/cameras/mesh_explanation.h"

#include <cmath>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// Shares above round to all of it, in percent with one digit.
constexpr double kAllButRounding = 0.9995;

std::string percent(double share) { return formatted("%.1f %%", 100 * share); }

std::string repairs_text(const CameraMeshEvidence& evidence) {
    std::string text;
    if (evidence.edges_flipped > 0) {
        text += "; " + std::to_string(evidence.edges_flipped) +
                (evidence.edges_flipped == 1 ? " edge was" : " edges were") + " flipped for that";
    }
    if (evidence.cameras_slid > 0) {
        text += "; the weights of " + std::to_string(evidence.cameras_slid) +
                (evidence.cameras_slid == 1 ? " camera" : " cameras") +
                " are those of a place up to " + percent(evidence.largest_slide_share) +
                " nearer or farther";
    }
    if (evidence.own_ray_share < kAllButRounding) {
        text += "; on their own rays to the scene cameras have " + percent(evidence.own_ray_share) +
                " of the weight";
    }
    return text;
}

}  // namespace

std::string mesh_explanation(const CameraMesh& mesh, const Arrangement& arrangement,
                             const CameraMeshEvidence& evidence,
                             const MeshExplanationParts& parts) {
    std::string text = name_of(mesh.construction);
    if (arrangement.inside_out) text += ", inside out (the cameras look away from their middle)";
    text += ": " + arrangement.reason + "; " + std::to_string(evidence.cameras_kept) + " of " +
            std::to_string(evidence.cameras_total) + " cameras are vertices of the mesh";
    if (evidence.cameras_kept < evidence.cameras_total) {
        text += parts.is_convex
                    ? ", the others stand within the convex hull"
                    : ", the others stand behind or before one of them as seen from the scene";
    }
    if (parts.has_scene) {
        text += formatted(
            "; %.0f %% of the scene's points lie in its kernel, where no ray crosses two faces",
            std::floor(100 * evidence.scene_share_in_kernel));
    }
    return text + repairs_text(evidence) + ".";
}

}  // namespace lumi
