#pragma once

#include "tests/calib/boards/synthetic_boards.h"

namespace lumi {

/// Cells of side 1, inner corners at (0, 0) to (columns - 2, rows - 2), a marker of OpenCV's
/// dictionary DICT_4X4_250 in every bright cell, numbered from the top left. The first cell is
/// bright in the layout that boards with an even number of rows had before OpenCV 4.6.
[[nodiscard]] BoardPrint printed_charuco(int columns, int rows, double marker_size,
                                         bool is_first_cell_bright);

/// Markers 36h11 of side `size` around (0, 0) to (columns - 1, rows - 1), numbered from the bottom
/// left as Kalibr does; Kalibr's have frames of two bits and dark squares between the corners.
[[nodiscard]] BoardPrint printed_aprilgrid(int columns, int rows, double size, int border_bits,
                                           bool has_corner_squares);

}  // namespace lumi
