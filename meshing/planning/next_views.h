#pragma once

#include <array>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/planning/predicted_error.h"

namespace lumi {

/// Where one more photograph would help most.
struct SuggestedView {
    /// Looks at the scene centre, or away from it where the others do; upright like its neighbours.
    Rigid3 cam_from_world;
    double error_px = 0.0;              ///< Predicted there without it.
    double worst_error_after_px = 0.0;  ///< The worst that is left with it and those before it.
    std::array<int, 2> nearest_views{-1, -1};  ///< The two nearest photographs.
    std::array<std::string, 2> steps;          ///< How to get there from each of them, in words.
};

struct CapturePlanOptions {
    int suggestions = 5;           ///< >= 0.
    double wished_error_px = 0.0;  ///< 0: no wish.
};

/// What to photograph next.
struct CapturePlan {
    DepthUncertainty uncertainty;
    std::vector<Hole> holes;  ///< As the capture is, the worst first.
    std::vector<SuggestedView> suggestions;
    /// Photographs to add until every predicted error is within the wish, each at the worst place
    /// at its time; -1 when more than `kMostPlanned` would be needed, or there is nothing between
    /// cameras to fill.
    int photographs_for_wish = 0;
};
inline constexpr int kMostPlanned = 500;

/// Plans from the poses alone: predicted errors between the cameras, then photographs at the worst
/// place, one after another, each taking part when the next is placed. Throws Error (E-MESH-NOVIEW,
/// E-PLAN-ONESPOT) without two cameras that stand in different directions from the scene or where
/// they stand behind each other (forward_motion.h), and (E-PLAN-NOSURFACE) where most do not face
/// what they would surround (preconditions.h).
[[nodiscard]] CapturePlan plan_capture(const Capture& capture, const std::vector<int>& view_indices,
                                       const CapturePlanOptions& options);

/// "go right by 21 %, up by 5 % of the distance to the subject": from where a camera stands to
/// another place, in the camera's own directions; steps below 1 % are left out.
[[nodiscard]] std::string steps_in_words(const Rigid3& cam_from_world,
                                         const Eigen::Vector3d& goal_in_world,
                                         double subject_distance);

}  // namespace lumi
