#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/boards/board_kind.h"
#include "calib/boards/board_views.h"
#include "calib/capture/image.h"
#include "calib/capture/posed_photographs.h"
#include "calib/work/progress.h"

namespace lumi {

/// What the user says about the board; what is left out is found from the photographs.
struct BoardRequest {
    std::optional<BoardKind> kind;
    /// Of inner corners, discs, squares or markers, either way round. What shows more is another
    /// board. 0: not said.
    int columns = 0;
    int rows = 0;
    /// Side of a square or marker, or diameter of a disc, to the distance between neighbours.
    double size_per_pitch = 0.0;  ///< 0: estimated.
};

/// A board, or part of one, in one photograph.
struct BoardDetection {
    BoardKind kind = BoardKind::kChessboard;
    BoardView view;
    int columns = 0;  ///< Of the part that was seen.
    int rows = 0;
    double size_per_pitch = 0.0;
    double step_px = 0.0;  ///< Median distance between neighbours.
    std::string markers;   ///< Family of the markers, and how many were read; else empty.
};

/// What one photograph holds: a board, or the reason why none was found.
struct BoardAnswer {
    std::optional<BoardDetection> board;
    LeftOut left_out;
};

/// Looks for one kind of board. For a kind of which others are a special case (a chessboard with
/// markers, circles of any arrangement) the answer says which it is.
[[nodiscard]] BoardAnswer detect_board(const GrayImage& picture, const std::string& name,
                                       BoardKind kind, const BoardRequest& request);

/// All photographs of a folder with the board in them.
struct BoardPhotographs {
    BoardKind kind = BoardKind::kChessboard;
    int columns = 0;  ///< Largest part seen.
    int rows = 0;
    BoardViews board;
    std::vector<BoardDetection> detections;  ///< One a view, in the same order.
    std::vector<LeftOut> left_out;
    std::size_t photographs = 0;
    std::vector<std::string> warnings;  ///< What was said of the board and could not be confirmed.
};

/// Finds the board in every photograph of a folder; the kind, unless it is given,
/// from a sample of them. Photographs are taken as stored, whatever their EXIF orientation says,
/// and those of another size than most are left out. Throws Error: E-INGEST-NOFOLDER,
/// E-BOARDS-NOPHOTOS, E-BOARDS-SIZES (no size is that of most), E-BOARDS-NOTFOUND (no board in any
/// photograph; the reasons are in the message), E-BOARDS-LARGER (only boards that are larger than
/// what was said), E-INTERRUPTED.
[[nodiscard]] BoardPhotographs find_boards(const std::filesystem::path& folder,
                                           const BoardRequest& request, int threads,
                                           Progress& progress);

}  // namespace lumi
