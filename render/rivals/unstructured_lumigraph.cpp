#include "render/rivals/unstructured_lumigraph.h"

#include <algorithm>
#include <cmath>

#include "meshing/rivals/unstructured_weights.h"
#include "render/rivals/seen_point.h"

namespace lumi {

Frame draw_unstructured_lumigraph(const Lumigraph& lumigraph, const Eye& eye,
                                  const EyeDepths& known,
                                  const UnstructuredLumigraphOptions& options) {
    const SameSurface same_surface(lumigraph, options.occlusion_epsilon);
    const double least_weighed = least_weighed_inverse_depth(lumigraph, eye);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    Frame frame = empty_frame(eye.camera);
    std::vector<Eigen::Vector3d> centres;
    std::vector<double> shares;
    std::vector<SeenPoint> seen;
    for (int y = 0; y < frame.color.height(); ++y) {
        for (int x = 0; x < frame.color.width(); ++x) {
            const ConsensusDepth& depth = known.depths(x, y);
            if (depth.support == 0) continue;
            const double inverse_depth = std::max(0.0, depth.inverse_depth);
            const Eigen::Vector4d point = scene_point(eye, x, y, inverse_depth);
            centres.clear();
            shares.clear();
            seen.clear();
            for (const LumigraphView& view : lumigraph.views) {
                const auto sight = seen_point(view, point);
                if (!sight || !sight->is_of(same_surface) || !(sight->share_in_view() > 0))
                    continue;
                centres.push_back(centre_in_world(view.cam_from_world));
                shares.push_back(sight->share_in_view());
                seen.push_back(*sight);
            }
            if (seen.empty()) continue;
            const std::vector<double> weights = unstructured_weights(
                centres, eye_in_world,
                point_in_world(eye, x, y, std::max(inverse_depth, least_weighed)), shares);
            Eigen::Vector3d color = Eigen::Vector3d::Zero();
            for (std::size_t i = 0; i < seen.size(); ++i)
                if (weights[i] > 0) color += weights[i] * seen[i].color();
            set_pixel(frame, x, y, color);
        }
    }
    return frame;
}

}  // namespace lumi
