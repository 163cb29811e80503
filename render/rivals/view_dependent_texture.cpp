#include "render/rivals/view_dependent_texture.h"

#include <algorithm>
#include <cmath>

#include "meshing/rivals/view_dependent_weights.h"
#include "render/rivals/seen_point.h"

namespace lumi {
namespace {

/// Inverse depths of one surface differ by no more than so many times what tells that a view sees
/// another.
constexpr double kTimesEpsilon = 2.0;

struct ChosenView {
    std::size_t index = 0;
    double weight = 0.0;
};

struct SurfacePixel {
    int x = 0;
    int y = 0;
    double inverse_depth = 0.0;
};

using Polygon = std::vector<SurfacePixel>;

SurfacePixel middle_of(const Polygon& polygon) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const SurfacePixel& pixel : polygon) mean += Eigen::Vector2d(pixel.x, pixel.y);
    mean /= static_cast<double>(polygon.size());
    const auto off = [&](const SurfacePixel& pixel) {
        return (Eigen::Vector2d(pixel.x, pixel.y) - mean).squaredNorm();
    };
    return *std::min_element(
        polygon.begin(), polygon.end(),
        [&](const SurfacePixel& a, const SurfacePixel& b) { return off(a) < off(b); });
}

/// Draws one frame.
class PolygonTexturing {
 public:
    PolygonTexturing(const Lumigraph& lumigraph, const Eye& eye, const EyeDepths& known,
                     const ViewDependentTextureOptions& options)
        : lumigraph_(lumigraph),
          eye_(eye),
          eye_in_world_(centre_in_world(eye.cam_from_world)),
          known_(known),
          side_px_(options.polygon_px),
          same_as_seen_(lumigraph, options.occlusion_epsilon),
          same_polygon_(lumigraph, kTimesEpsilon * options.occlusion_epsilon),
          least_weighed_(least_weighed_inverse_depth(lumigraph, eye)),
          frame_(empty_frame(eye.camera)) {}

    Frame drawn() {
        for (int top = 0; top < frame_.color.height(); top += side_px_)
            for (int left = 0; left < frame_.color.width(); left += side_px_)
                for (Polygon& polygon : polygons_of_square(left, top)) texture(std::move(polygon));
        return std::move(frame_);
    }

 private:
    [[nodiscard]] std::vector<Polygon> polygons_of_square(int left, int top) const {
        std::vector<Polygon> polygons;
        for (int y = top; y < std::min(top + side_px_, frame_.color.height()); ++y) {
            for (int x = left; x < std::min(left + side_px_, frame_.color.width()); ++x) {
                const ConsensusDepth& depth = known_.depths(x, y);
                if (depth.support == 0) continue;
                const SurfacePixel pixel{x, y, std::max(0.0, depth.inverse_depth)};
                auto same =
                    std::find_if(polygons.begin(), polygons.end(), [&](const Polygon& polygon) {
                        return same_polygon_(polygon.front().inverse_depth, pixel.inverse_depth);
                    });
                if (same == polygons.end()) same = polygons.insert(same, Polygon{});
                same->push_back(pixel);
            }
        }
        return polygons;
    }

    /// What the views of its middle do not see is textured by itself.
    void texture(Polygon polygon) {
        while (!polygon.empty()) {
            const SurfacePixel middle = middle_of(polygon);
            const std::vector<ChosenView> chosen = views_of(middle);
            std::erase_if(polygon, [&](const SurfacePixel& pixel) {
                return blend(pixel, chosen) || (pixel.x == middle.x && pixel.y == middle.y);
            });
        }
    }

    [[nodiscard]] std::optional<SeenPoint> sight_of(const SurfacePixel& pixel,
                                                    std::size_t view) const {
        const auto seen = seen_point(lumigraph_.views[view],
                                     scene_point(eye_, pixel.x, pixel.y, pixel.inverse_depth));
        return seen && seen->is_of(same_as_seen_) ? seen : std::nullopt;
    }

    [[nodiscard]] std::vector<ChosenView> views_of(const SurfacePixel& middle) const {
        std::vector<std::size_t> seeing;
        std::vector<Eigen::Vector3d> centres;
        for (std::size_t i = 0; i < lumigraph_.views.size(); ++i) {
            if (!sight_of(middle, i)) continue;
            seeing.push_back(i);
            centres.push_back(centre_in_world(lumigraph_.views[i].cam_from_world));
        }
        const std::vector<double> weights =
            view_dependent_weights(centres, eye_in_world_,
                                   point_in_world(eye_, middle.x, middle.y,
                                                  std::max(middle.inverse_depth, least_weighed_)));
        std::vector<ChosenView> chosen;
        for (std::size_t k = 0; k < seeing.size(); ++k)
            if (weights[k] > 0) chosen.push_back({seeing[k], weights[k]});
        return chosen;
    }

    /// Whether one of the views sees it.
    bool blend(const SurfacePixel& pixel, const std::vector<ChosenView>& chosen) {
        Eigen::Vector3d color = Eigen::Vector3d::Zero();
        double sum = 0;
        for (const ChosenView& view : chosen) {
            const auto seen = sight_of(pixel, view.index);
            if (!seen) continue;
            color += view.weight * seen->color();
            sum += view.weight;
        }
        if (sum > 0) set_pixel(frame_, pixel.x, pixel.y, color / sum);
        return sum > 0;
    }

    const Lumigraph& lumigraph_;
    const Eye& eye_;
    Eigen::Vector3d eye_in_world_;
    const EyeDepths& known_;
    int side_px_;
    SameSurface same_as_seen_;
    SameSurface same_polygon_;
    double least_weighed_;
    Frame frame_;
};

}  // namespace

Frame draw_view_dependent_texture(const Lumigraph& lumigraph, const Eye& eye,
                                  const EyeDepths& known,
                                  const ViewDependentTextureOptions& options) {
    return PolygonTexturing(lumigraph, eye, known, options).drawn();
}

}  // namespace lumi
