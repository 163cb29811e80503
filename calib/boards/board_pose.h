#pragma once

#include <optional>

#include "calib/boards/board_projection.h"
#include "calib/capture/camera.h"

namespace lumi {

/// Where a board stands before a camera, and how well that explains what was seen.
struct SolvedBoardPose {
    BoardPose cam_from_board{};
    double rms_px = 0.0;  ///< Root mean square of the distances between predicted and seen.
};

/// The pose of a board for a known lens: from the homography between board and viewing rays (so
/// that wide angles are no exception), refined by Levenberg and Marquardt's method over pixels. A
/// plane seen nearly head on has two poses that look alike: both are tried. Empty when the points
/// do not determine one. Only lenses without distortion, and OPENCV_FISHEYE, can start from
/// nothing; others expect `start`.
[[nodiscard]] std::optional<SolvedBoardPose> solve_board_pose(
    const BoardView& view, const Camera& lens, double size_per_pitch,
    const std::optional<BoardPose>& start = std::nullopt);

/// The same without the second try and with few steps: to compare lenses, not to keep.
[[nodiscard]] std::optional<SolvedBoardPose> rough_board_pose(const BoardView& view,
                                                              const Camera& lens,
                                                              double size_per_pitch);

/// Pixels where the points of a view are predicted; a point that the lens cannot see is NaN.
[[nodiscard]] std::vector<Eigen::Vector2d> predicted_px(const BoardView& view, const Camera& lens,
                                                        double size_per_pitch,
                                                        const BoardPose& cam_from_board,
                                                        const BoardBow& bow = kNotBent);

/// Angle between the board's normal and the line of sight to its middle, in degrees.
[[nodiscard]] double board_tilt_deg(const BoardView& view, double size_per_pitch,
                                    const BoardPose& cam_from_board);

}  // namespace lumi
