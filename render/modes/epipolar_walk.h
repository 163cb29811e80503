#pragma once

#include <Eigen/Core>

#include "render/modes/tiled_depth.h"

namespace lumi {

/// One view as a ray of the eye sees it: places along its epipolar line.
struct EpipolarLine {
    Eigen::Vector3d at_infinity;        ///< Homogeneous place at inverse depth 0.
    Eigen::Vector3d per_inverse_depth;  ///< What each unit of the eye's inverse depth adds.

    [[nodiscard]] Eigen::Vector3d at(double inverse_depth) const {
        return at_infinity + inverse_depth * per_inverse_depth;
    }
};

/// A ray of the eye on its way through a view's depth map, from near to far: places are in samples
/// of the map, inverse depths (q) those of the eye. What is far from all that a square of samples
/// holds is passed square by square.
class EpipolarWalk {
 public:
    EpipolarWalk(const EpipolarLine& line_in_samples, const TiledDepth& depth);

    struct Place {
        double z;  ///< Depth in the view over depth in the eye.
        double x;
        double y;
    };
    [[nodiscard]] Place at(double q) const {
        const double z = line_.at_infinity.z() + q * line_.per_inverse_depth.z();
        const double inverse_z = 1 / z;
        return {z, (line_.at_infinity.x() + q * line_.per_inverse_depth.x()) * inverse_z,
                (line_.at_infinity.y() + q * line_.per_inverse_depth.y()) * inverse_z};
    }

    /// Samples that the place moves for each unit of q.
    [[nodiscard]] double speed(const Place& place) const;

    /// The q at which the ray is as far from the view as something there.
    [[nodiscard]] double meets(double inverse_depth_in_view) const {
        return inverse_depth_in_view * line_.at_infinity.z() /
               (1 - inverse_depth_in_view * line_.per_inverse_depth.z());
    }

    /// The first q, from the given one on, at which the ray might meet something: what lies before
    /// all that a square holds is passed. `far_end` at the least.
    [[nodiscard]] double past_free(double q, double far_end) const;
    /// The same for a ray that is behind something: the first q at which it might come out.
    [[nodiscard]] double past_hiding(double q, double far_end) const;

 private:
    struct Square {
        int side;
        int column;
        int row;
        TiledDepth::Range range;
    };
    [[nodiscard]] Square coarse_at(const Place& place) const;
    [[nodiscard]] Square fine_at(const Place& place) const;
    /// The q at which the ray is a little beyond the square; `far_end` at the least.
    [[nodiscard]] double leaves(const Square& square, double q, double far_end) const;

    const EpipolarLine& line_;
    const TiledDepth& depth_;
    bool x_falls_;  ///< As the ray goes on.
    bool y_falls_;
};

}  // namespace lumi
