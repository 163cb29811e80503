#pragma once

#include <optional>
#include <vector>

#include "calib/boards/board_pattern.h"
#include "calib/boards/marker_codes.h"

namespace lumi {

/// How the markers of a ChArUco board are numbered: from the top left, row by row, in the bright
/// cells.
struct CharucoLayout {
    int columns = 0;  ///< Cells in a row; 0 when too little is seen to tell.
    /// The first cell is bright and has marker 0, as boards with an even number of rows were
    /// printed before OpenCV 4.6; since then the first cell is dark.
    bool is_first_cell_bright = false;
    std::size_t markers = 0;  ///< That agree.
};

/// The numbering that the markers in the cells of a chessboard agree on, whichever way the board is
/// turned; empty when three quarters of them do not agree on any.
[[nodiscard]] std::optional<CharucoLayout> charuco_layout(const std::vector<PatternNode>& corners,
                                                          const std::vector<DarkQuad>& quads,
                                                          const MarkerFamily& family);

/// How the markers of a grid are numbered: by rows, one more from each to the next.
struct MarkerGridLayout {
    int columns = 0;           ///< Of the whole grid.
    std::size_t markers = 0;   ///< That agree.
    std::vector<bool> agrees;  ///< One a node.
};

/// The numbering of a grid of markers: `ids` one a node. Empty when three quarters do not agree.
[[nodiscard]] std::optional<MarkerGridLayout> marker_grid_layout(
    const std::vector<PatternNode>& nodes, const std::vector<int>& ids);

}  // namespace lumi
