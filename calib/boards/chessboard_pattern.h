#pragma once

#include <vector>

#include "calib/boards/board_pattern.h"
#include "calib/capture/image.h"

namespace lumi {

struct ChessboardPattern {
    std::vector<PatternNode> nodes;  ///< Corners to a fraction of a pixel; none: not found.
    std::size_t candidates = 0;      ///< Points that look like corners, wherever.
    double median_step_px = 0.0;     ///< Between neighbouring corners.
};

/// The largest chessboard, or part of one, of any size; corners inside markers (ChArUco) do not
/// disturb it. Searches from fine to coarse, so that blurred corners are found as well, and refines
/// in the photograph itself.
[[nodiscard]] ChessboardPattern find_chessboard(const GrayImage& picture);
/// The same with refinement that keeps close to the corners, away from markers in the bright cells.
[[nodiscard]] ChessboardPattern find_chessboard_with_markers(const GrayImage& picture);

}  // namespace lumi
