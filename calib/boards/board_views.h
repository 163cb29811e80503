#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

namespace lumi {

/// A point of a board that was seen in a photograph.
struct BoardPoint {
    /// On the board, in pitches (the distance between neighbours is 1): `place`, plus
    /// `along_size` times the size of a printed square, which may have to be estimated.
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    Eigen::Vector2d along_size = Eigen::Vector2d::Zero();
    Eigen::Vector2d px = Eigen::Vector2d::Zero();
};

/// What one photograph shows of a board. Where a regular pattern counts from is arbitrary: the
/// pose, which is estimated, takes it up. Parts of a board are as good as the whole.
struct BoardView {
    std::string photograph;
    std::vector<BoardPoint> points;
    /// How it counts, for what all photographs show alike, such as a bow: where it has the middle
    /// of the board, in pitches, and by what angle (from x towards y) it is turned against the
    /// others. Set by count_alike.
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double turn_rad = 0.0;
};

/// Photographs of a board by one camera.
struct BoardViews {
    int width_px = 0;
    int height_px = 0;
    std::vector<BoardView> views;
    double size_per_pitch = 0.0;  ///< Of squares (their side) or discs (their diameter); 0: points.
    bool is_size_known = false;   ///< Given, not to be estimated.
    bool are_discs = false;       ///< Points are centroids of discs as seen.
    int turns_alike = 4;          ///< Turns that the lattice looks the same after; 6: hexagonal.
};

}  // namespace lumi
