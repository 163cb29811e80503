#include "render/rivals/dynamically_reparameterized.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "calib/work/parallel_for.h"
#include "meshing/warp/parallax.h"
#include "render/rivals/seen_point.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// So many cameras are blended at least, where as many show the point.
constexpr std::size_t kLeastBlended = 3;
/// Of the distance of the first that is left out: so that cameras that are all as far, as in the
/// middle of a grid or at one place, are blended.
constexpr double kBeyondLeftOut = 1 + 1e-6;

/// A camera that shows the point of the focal plane that a ray meets.
struct ApertureCamera {
    double from_ray = 0.0;  ///< Distance of its centre, in world units.
    PhotographedPoint photographed;
};

class ApertureBlend {
 public:
    ApertureBlend(const Lumigraph& lumigraph, const Eye& eye, const SyntheticAperture& aperture)
        : lumigraph_(lumigraph),
          eye_(eye),
          eye_in_world_(centre_in_world(eye.cam_from_world)),
          diameter_(aperture.diameter),
          plane_(aperture.focal_plane.depth > 0
                     ? focal_plane_inverse_depth(aperture.focal_plane, eye)
                     : scene_plane_inverse_depth(lumigraph, eye)) {
        for (const LumigraphView& view : lumigraph.views)
            centres_in_world_.push_back(centre_in_world(view.cam_from_world));
    }

    void draw_row(int y, Frame& frame) const {
        std::vector<ApertureCamera> cameras;
        for (int x = 0; x < frame.color.width(); ++x) {
            find_cameras(x, y, cameras);
            blend(cameras, radius_of(cameras), x, y, frame);
        }
    }

 private:
    void find_cameras(int x, int y, std::vector<ApertureCamera>& cameras) const {
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
            if (!photographed || !(photographed->share_in_view() > 0)) continue;
            cameras.push_back({(centre - eye_in_world_).cross(ray).norm(), *photographed});
        }
    }

    /// Half of the diameter, or more where cameras are sparse. Reorders them.
    [[nodiscard]] double radius_of(std::vector<ApertureCamera>& cameras) const {
        if (cameras.size() <= kLeastBlended) return std::numeric_limits<double>::infinity();
        const auto first_left_out = cameras.begin() + kLeastBlended;
        std::nth_element(cameras.begin(), first_left_out, cameras.end(),
                         [](const ApertureCamera& a, const ApertureCamera& b) {
                             return a.from_ray < b.from_ray;
                         });
        const double radius = std::max(diameter_ / 2, kBeyondLeftOut * first_left_out->from_ray);
        return radius > 0 ? radius : std::numeric_limits<double>::infinity();
    }

    static void blend(const std::vector<ApertureCamera>& cameras, double radius, int x, int y,
                      Frame& frame) {
        Eigen::Vector3d color = Eigen::Vector3d::Zero();
        double sum = 0;
        for (const ApertureCamera& camera : cameras) {
            if (camera.from_ray >= radius) continue;
            const double weight =
                (1 - camera.from_ray / radius) * camera.photographed.share_in_view();
            color += weight * camera.photographed.color();
            sum += weight;
        }
        if (sum > 0) set_pixel(frame, x, y, color / sum);
    }

    const Lumigraph& lumigraph_;
    const Eye& eye_;
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
    return 2 * typical_baseline(centres);
}

}  // namespace lumi
