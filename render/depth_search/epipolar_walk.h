#pragma once

#include <Eigen/Core>
#include <optional>

#include "calib/capture/inverse_depth_warp.h"
#include "render/depth_search/tiled_depth.h"

namespace lumi {

/// One view as a ray of the eye sees it: places along its epipolar line.
struct EpipolarLine {
    Eigen::Vector3d at_infinity;        ///< Homogeneous place at inverse depth 0.
    Eigen::Vector3d per_inverse_depth;  ///< What each unit of the eye's inverse depth adds.

    [[nodiscard]] Eigen::Vector3d homogeneous_at(double inverse_depth) const {
        return at_infinity + inverse_depth * per_inverse_depth;
    }
    /// Empty where the point is not in front of the view.
    [[nodiscard]] std::optional<WarpedPixel> at(double inverse_depth) const {
        return WarpedPixel::of(homogeneous_at(inverse_depth), inverse_depth);
    }
};

/// A stretch of a ray by the inverse depths of its ends in the eye, near end first.
struct RayStretch {
    double near_end;
    double far_end;

    [[nodiscard]] bool is_empty() const { return near_end < far_end; }
};

/// A ray of the eye on its way through a view's depth map, from the near end of a stretch (share 0)
/// to the far end (share 1): places are in samples of the map. What is far from all that a square
/// of samples holds is passed square by square.
///
/// Shares are of the way in the map: along the picture of a ray its inverse depth is affine, so
/// that nothing has to be divided on the way.
class EpipolarWalk {
 public:
    /// The ray is to be before the view all along the stretch.
    EpipolarWalk(const EpipolarLine& line_in_samples, const RayStretch& stretch,
                 const TiledDepth& depth);

    struct Place {
        double x;
        double y;
        double inverse_depth;  ///< In the view.
    };
    [[nodiscard]] Place at(double share) const {
        return {begin_.x + share * way_.x, begin_.y + share * way_.y,
                begin_.inverse_depth + share * way_.inverse_depth};
    }

    /// The eye's inverse depth at this share of the way.
    [[nodiscard]] double inverse_depth_in_eye(double share) const {
        return (begin_.inverse_depth + share * way_.inverse_depth) /
               (begin_eye_over_view_ + share * way_eye_over_view_);
    }

    /// The share of the way that one sample of the map takes: more than 1 where the way is shorter
    /// than a sample, up to the largest number where the whole ray lies in one place.
    [[nodiscard]] double per_sample() const { return per_sample_; }

    /// Growth of the ray's inverse depth in the view over one sample of its way.
    [[nodiscard]] double inverse_depth_per_sample() const {
        return way_.inverse_depth * per_sample_;
    }

    /// The share at which the ray is as far from the view as something there; it may lie beyond
    /// the ends, also infinitely far.
    [[nodiscard]] double meets(double inverse_depth_in_view) const {
        return (inverse_depth_in_view - begin_.inverse_depth) * per_inverse_depth_;
    }

    /// The first share, from the given one on, at which the ray might meet something: what lies
    /// before all that a square holds is passed. 1 at the most.
    [[nodiscard]] double past_free(double share) const;
    /// The same for a ray that is behind something: the first share at which it might come out.
    [[nodiscard]] double past_hiding(double share) const;

 private:
    struct Square {
        int side;
        int column;
        int row;
        TiledDepth::Range range;
    };
    [[nodiscard]] Square coarse_at(const Place& place) const;
    [[nodiscard]] Square fine_at(const Place& place) const;
    /// The share at which the ray is a little beyond the square.
    [[nodiscard]] double leaves(const Square& square) const;

    const TiledDepth& depth_;
    Place begin_;
    Place way_;                   ///< From the near end to the far end.
    double begin_eye_over_view_;  ///< Depth in the eye over depth in the view.
    double way_eye_over_view_;
    double per_sample_;
    double per_inverse_depth_;
    double per_x_;
    double per_y_;
};

}  // namespace lumi
