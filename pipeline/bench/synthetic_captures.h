#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "pipeline/synth/hashed_random.h"

namespace lumi {

[[nodiscard]] Eigen::Vector3d random_direction(HashedRandom& random);

/// A hand that goes all around the origin at distances about 1: places on a spiral (Fibonacci),
/// each off by a third of the spacing, at distances that vary by the share `roughness` on their
/// own.
[[nodiscard]] std::vector<Eigen::Vector3d> hand_held_centres(int count, double roughness,
                                                             HashedRandom& random);

/// Cameras at the centres that look at the origin, and scene points in a ball about it. Every point
/// is seen by a few cameras only, so that large captures stay small.
[[nodiscard]] Capture capture_around(const std::vector<Eigen::Vector3d>& centres,
                                     double scene_radius, HashedRandom& random);

/// A place between two of the scene's points.
[[nodiscard]] Eigen::Vector3d random_target(const Capture& capture, HashedRandom& random);

/// One way in which hands place cameras.
struct ArrangedCapture {
    std::string name;
    Capture capture;
    Eigen::Vector3d side = Eigen::Vector3d::UnitX();  ///< Where the cameras stand, seen from the
    double spread_deg = 180.0;                        ///< scene: rays come from about there.
    bool inside_out = false;
};

/// Every arrangement that the camera mesh has a construction for, with about `cameras` cameras each
/// (where its name does not say how many). As in a hand, places are off by up to the share
/// `unsteady` of the distance.
[[nodiscard]] std::vector<ArrangedCapture> arranged_captures(int cameras, std::uint64_t seed,
                                                             double unsteady = 0.02);

}  // namespace lumi
