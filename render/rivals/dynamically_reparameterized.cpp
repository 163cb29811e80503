#include "render/rivals/dynamically_reparameterized.h"

#include <algorithm>
#include <vector>

#include "calib/work/parallel_for.h"
#include "meshing/warp/parallax.h"
#include "render/reference/photograph_samples.h"
#include "render/rivals/cone_of_cameras.h"
#include "render/rivals/seen_point.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// Half of the usual aperture, in typical distances from a camera to the next: half of that, the
/// cone would be little wider than where cameras are sparse.
constexpr double kUsualRadius = 2.0;

class ApertureBlend {
 public:
    ApertureBlend(const Lumigraph& lumigraph, const Eye& eye, const SyntheticAperture& aperture)
        : lumigraph_(lumigraph),
          eye_(eye),
          samples_(lumigraph, eye, {}),
          eye_in_world_(centre_in_world(eye.cam_from_world)),
          diameter_(aperture.diameter),
          plane_(aperture.focal_plane.depth > 0
                     ? focal_plane_inverse_depth(aperture.focal_plane, eye)
                     : scene_plane_inverse_depth(lumigraph, eye)) {
        for (const LumigraphView& view : lumigraph.views)
            centres_in_world_.push_back(centre_in_world(view.cam_from_world));
    }

    void draw_row(int y, Frame& frame) const {
        std::vector<PassedCamera> cameras;
        for (int x = 0; x < frame.color.width(); ++x) {
            find_cameras(x, y, cameras);
            blend(cameras, x, y, frame);
        }
    }

 private:
    /// Those that show the point, the nearest to the ray first.
    void find_cameras(int x, int y, std::vector<PassedCamera>& cameras) const {
        cameras.clear();
        const double inverse_depth =
            std::max(0.0, plane_.dot(Eigen::Vector3d(x + 0.5, y + 0.5, 1)));
        const Eigen::Vector4d point = scene_point(eye_, x, y, inverse_depth);
        const Eigen::Vector3d ray =
            (eye_.cam_from_world.rotation.conjugate() * unproject(eye_.camera, {x + 0.5, y + 0.5}))
                .normalized();
        for (std::size_t i = 0; i < centres_in_world_.size(); ++i) {
            const Eigen::Vector3d& centre = centres_in_world_[i];
            if (!((point.head<3>() - point.w() * centre).dot(ray) > 0)) continue;
            const auto photographed = photographed_point(lumigraph_.views[i], point);
            if (!photographed) continue;
            const double share = photographed->share_in_view();
            if (!(share > 0)) continue;
            cameras.push_back({(centre - eye_in_world_).cross(ray).norm(), share,
                               static_cast<int>(i), photographed->pixel});
        }
        std::sort(cameras.begin(), cameras.end(), [](const PassedCamera& a, const PassedCamera& b) {
            return a.from_ray < b.from_ray;
        });
    }

    void blend(const std::vector<PassedCamera>& cameras, int x, int y, Frame& frame) const {
        const double radius = std::max(diameter_ / 2, least_cone_radius(cameras));
        Eigen::Vector3d color = Eigen::Vector3d::Zero();
        double sum = 0;
        for (const PassedCamera& camera : cameras) {
            const double weight = cone_weight(camera, radius);
            if (!(weight > 0)) break;
            color += weight * samples_.color(camera.view_index, camera.pixel);
            sum += weight;
        }
        if (sum > 0) set_pixel(frame, x, y, color / sum);
    }

    const Lumigraph& lumigraph_;
    const Eye& eye_;
    PhotographSamples samples_;
    Eigen::Vector3d eye_in_world_;
    double diameter_;
    Eigen::Vector3d plane_;  ///< As a line of inverse depths (focal_plane.h).
    std::vector<Eigen::Vector3d> centres_in_world_;
};

}  // namespace

Frame draw_dynamically_reparameterized(const Lumigraph& lumigraph, const Eye& eye,
                                       const SyntheticAperture& aperture) {
    const ApertureBlend blend(lumigraph, eye, aperture);
    Frame frame = empty_frame(eye.camera);
    parallel_for(frame.color.height(), aperture.threads, [&](int y) { blend.draw_row(y, frame); });
    return frame;
}

double usual_aperture_diameter(const Lumigraph& lumigraph) {
    std::vector<Eigen::Vector3d> centres;
    for (const LumigraphView& view : lumigraph.views)
        centres.push_back(centre_in_world(view.cam_from_world));
    return 2 * kUsualRadius * typical_baseline(centres);
}

}  // namespace lumi
