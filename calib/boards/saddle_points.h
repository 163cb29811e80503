#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// A point where two dark and two bright quarters meet, as inside a chessboard.
struct SaddlePoint {
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
    /// (cos 2a, sin 2a) of the direction a towards its bright quarters, of length one.
    Eigen::Vector2d bright_axis = Eigen::Vector2d::UnitX();
    double contrast = 0.0;  ///< Grey levels between bright and dark.
    double response = 0.0;
};

/// Chessboard corners by the ring of sixteen samples of Bennett and Lasenby (ChESS: quick and
/// robust detection of chess-board features, CVIU 2014), at most `max_points` of the strongest.
/// Accepts by the shape of the ring alone, so that faint corners beside glare count like others.
[[nodiscard]] std::vector<SaddlePoint> detect_saddle_points(const GrayImage& picture,
                                                            std::size_t max_points = 6000);

}  // namespace lumi
