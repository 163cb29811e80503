#include "render/rivals/unstructured_lumigraph.h"

#include <cmath>

#include "meshing/rivals/unstructured_weights.h"
#include "render/reference/eye_depths.h"
#include "render/rivals/seen_point.h"

namespace lumi {

Frame draw_unstructured_lumigraph(const Lumigraph& lumigraph, const Eye& eye,
                                  const UnstructuredLumigraphOptions& options) {
    const EyeDepths known = eye_depths(lumigraph, eye, options.tolerance_px);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    Frame frame = empty_frame(eye.camera);
    for (int y = 0; y < frame.color.height(); ++y) {
        for (int x = 0; x < frame.color.width(); ++x) {
            const ConsensusDepth& depth = known.depths(x, y);
            if (depth.support == 0 || !(depth.inverse_depth > 0)) continue;
            const Eigen::Vector3d point = point_in_world(eye, x, y, depth.inverse_depth);
            std::vector<Eigen::Vector3d> centres;
            std::vector<SeenPoint> seen;
            for (const LumigraphView& view : lumigraph.views) {
                const auto sight = seen_point(view, point);
                if (!sight || sight->depth_difference_share() > options.occlusion_epsilon) continue;
                centres.push_back(centre_in_world(view.cam_from_world));
                seen.push_back(*sight);
            }
            if (seen.empty()) continue;
            const std::vector<double> weights = unstructured_weights(centres, eye_in_world, point);
            Eigen::Vector3d color = Eigen::Vector3d::Zero();
            for (std::size_t i = 0; i < seen.size(); ++i)
                if (weights[i] > 0) color += weights[i] * seen[i].color();
            set_pixel(frame, x, y, color);
        }
    }
    return frame;
}

}  // namespace lumi
