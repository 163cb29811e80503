#pragma once

#include <vector>

#include "calib/work/progress.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// How far two cameras are apart as one sees a scene from them: the angle between their directions
/// from `centre`, and half the logarithm of the ratio of their distances.
[[nodiscard]] double viewpoint_distance(const OpticalAxis& a, const OpticalAxis& b,
                                        const Eigen::Vector3d& centre);

/// All views, the one that is missed most first: the first k of them stand for all.
///
/// From the last on, each is the view whose removal costs least. What a removal costs is the sum of
/// - what the photographs of all views lose, each predicted from those around it without itself
///   (thumbnail_prediction.h): a held-out view suffers that, and a view with a wrong pose or wrong
///   depth does harm that its removal ends;
/// - (d / s)^2 dB where each removed view stood, for a nearest view at the distance d: errors of
///   interpolation grow with its square; s is the median distance of all views to their nearest.
///   Thumbnails are judged where photographs were taken, but people look from everywhere: this
///   keeps gaps from growing.
/// Found anew are the costs of views that lose or gain a user, or share one with what left; not
/// those that change only because a view leaves that would have been drawn from instead: found
/// anew, too, they draw held-out photographs of half of the views no better, mostly worse.
/// Without any depth, or with more than 1500 views, the order is `views_far_apart`.
/// `views` and `axes` list the same cameras; photographs may be thumbnails already (thumbnail_of).
[[nodiscard]] std::vector<int> views_by_worth(const std::vector<PicturedView>& views,
                                              const std::vector<OpticalAxis>& axes,
                                              const Eigen::Vector3d& centre,
                                              const Progress& progress);

/// All views, each the farthest from those before it (farthest_first.h), the middle one first: near
/// duplicates come last.
[[nodiscard]] std::vector<int> views_far_apart(const std::vector<OpticalAxis>& axes,
                                               const Eigen::Vector3d& centre);

}  // namespace lumi
