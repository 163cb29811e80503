#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "render/lumigraph/depth_mesh.h"
#include "render/lumigraph/lumigraph.h"
#include "render/modes/pixel_transfer.h"
#include "render/modes/view_geometry.h"

namespace lumi {

/// Where a ray of the eye meets the scene.
struct RayHit {
    double inverse_depth = 0.0;  ///< Along the eye's optical axis.
    DepthKind kind = DepthKind::kSeen;
    int support = 0;  ///< How many of the views asked meet it there.
};

/// One view as a ray of the eye sees it: pixels along its epipolar line.
struct EpipolarLine {
    Eigen::Vector3d at_infinity;        ///< Homogeneous pixel at inverse depth 0.
    Eigen::Vector3d per_inverse_depth;  ///< What each unit of the eye's inverse depth adds.

    [[nodiscard]] Eigen::Vector3d at(double inverse_depth) const {
        return at_infinity + inverse_depth * per_inverse_depth;
    }
};

/// Finds where rays of one eye first meet the scene in the depth maps of views that stand
/// elsewhere: the inverse search of Vogelgsang and Greiner (2000), which the paper uses for depth
/// (section 4), here along the epipolar line from near to far.
class DepthSearch {
 public:
    /// `views` need depth maps; keeps references to both.
    DepthSearch(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                const Eye& eye, double tolerance_px);

    /// What the ray through `pixel` meets first in the depth maps of three views (a view may be
    /// named twice): the nearest that two agree on, or else the nearest, of the most reliable kind.
    /// The third is not asked when the first two have both seen it; the second always is: that it
    /// sees what the first one meets does not tell what it meets before. Empty when the ray meets
    /// nothing in any of them.
    [[nodiscard]] std::optional<RayHit> first_hit(const Eigen::Vector2d& pixel,
                                                  const std::array<int, 3>& view_indices) const;

    /// 1 when the view sees the point at `inverse_depth` on the eye's ray through `pixel`, 0 when
    /// it sees something else or the point lies outside of its photograph; between, a ramp.
    [[nodiscard]] double visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                                    int view_index) const;

    /// How much a view counts at a pixel near the border of its photograph; 0 outside.
    [[nodiscard]] double inside(int view_index, const Eigen::Vector2d& view_pixel) const;

    /// How far inside of its photograph a view sees it (shell_opacity.h).
    [[nodiscard]] double inner_share_of(int view_index, const Eigen::Vector2d& view_pixel) const;

    /// Whether one hit lies before another by more than two views of one surface may differ.
    [[nodiscard]] bool is_before(const RayHit& hit, const RayHit& other) const {
        return hit.inverse_depth > other.inverse_depth + agreeing_inverse_depth_;
    }

    /// What is farther is as good as infinitely far.
    [[nodiscard]] double least_inverse_depth() const { return least_inverse_depth_; }

    [[nodiscard]] EpipolarLine line_in(int view_index, const Eigen::Vector2d& pixel) const;

 private:
    /// A view as the eye needs it.
    struct Target {
        PixelTransfer view_from_eye;
        Eigen::Vector2d samples_per_pixel = Eigen::Vector2d::Zero();
        double disparity_px = 0.0;  ///< Pixels per unit of inverse depth (view_geometry.h).
        double max_disparity_px = 0.0;
        double max_inverse_depth = 0.0;  ///< Of the view's depth map.
    };
    /// A stretch of inverse depths, near end first, over which a point lies in a photograph.
    struct Stretch {
        double near_end;
        double far_end;
    };
    [[nodiscard]] Stretch visible_stretch(int view_index, const EpipolarLine& line) const;
    /// The first inverse depth from `q` on at which the ray might meet something in the view: what
    /// lies before all that a tile of its depth map holds is skipped.
    [[nodiscard]] double past_free_tiles(int view_index, const EpipolarLine& line, double q,
                                         double far_end) const;
    [[nodiscard]] std::optional<RayHit> first_hit_in(int view_index,
                                                     const Eigen::Vector2d& pixel) const;
    /// The same for what lies behind the first surface: the first inverse depth from `q` on at
    /// which the ray might come out from behind. Tiles whose farthest sample is still before it are
    /// skipped.
    [[nodiscard]] double past_hiding_tiles(int view_index, const EpipolarLine& line, double q,
                                           double far_end) const;
    /// The hit between a point in front of the surface and one behind it; empty at a tear.
    [[nodiscard]] std::optional<RayHit> refined(int view_index, const EpipolarLine& line,
                                                const Stretch& bracket) const;
    /// The inverse depth that a view sees at a pixel within its photograph: interpolated where it
    /// is one surface, the nearest sample at a tear.
    [[nodiscard]] double surface_at(int view_index, const Eigen::Vector2d& pixel) const;
    /// Of the nearest sample.
    [[nodiscard]] DepthKind kind_at(int view_index, const Eigen::Vector2d& pixel) const;
    [[nodiscard]] double sample_at(int view_index, const Eigen::Vector2d& pixel) const;

    const Lumigraph& lumigraph_;
    const std::vector<ViewGeometry>& geometries_;
    double tolerance_px_;
    double agreeing_inverse_depth_;
    double max_inverse_depth_;  ///< Of the eye: nothing nearer is looked for.
    double least_inverse_depth_;
    std::vector<Target> targets_;
};

}  // namespace lumi
