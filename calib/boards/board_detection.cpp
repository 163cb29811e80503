#include "calib/boards/board_detection.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "calib/boards/chessboard_pattern.h"
#include "calib/boards/grid_patterns.h"
#include "calib/boards/marker_codes.h"
#include "calib/boards/marker_layout.h"
#include "calib/boards/picture_faults.h"

namespace lumi {
namespace {

/// Half a square from its centre to each corner, in the order of PatternNode::corners_px.
constexpr std::array<std::array<double, 2>, 4> kCornerOfSquare{
    {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}};

LatticeExtent extent_of(const std::vector<PatternNode>& nodes) {
    Lattice lattice;
    for (std::size_t index = 0; index < nodes.size(); ++index) lattice[nodes[index].cell] = index;
    return extent_of(lattice);
}

/// Every other row shifted: the pattern fills the rows and columns that run along its diagonals
/// better than its own.
bool stands_on_a_corner(const std::vector<PatternNode>& nodes) {
    std::vector<PatternNode> turned;
    for (const PatternNode& node : nodes) {
        turned.push_back(
            {{node.cell.column + node.cell.row, node.cell.row - node.cell.column}, node.px, {}});
    }
    const auto filled = [&](const std::vector<PatternNode>& some, double share_of_cells) {
        const LatticeExtent extent = extent_of(some);
        return static_cast<double>(some.size()) /
               (share_of_cells * extent.columns() * extent.rows());
    };
    return filled(turned, 0.5) > 1.15 * filled(nodes, 1.0);
}

void take_points(const std::vector<PatternNode>& nodes, LatticeShape shape, BoardView& view) {
    for (const PatternNode& node : nodes) {
        const Eigen::Vector2d place = position_of(node.cell, shape);
        if (node.corners_px.empty()) {
            view.points.push_back({place, Eigen::Vector2d::Zero(), node.px});
            continue;
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            view.points.push_back({place,
                                   {kCornerOfSquare[corner][0], kCornerOfSquare[corner][1]},
                                   node.corners_px[corner]});
        }
    }
}

void take_extent(const std::vector<PatternNode>& nodes, BoardDetection& board) {
    const LatticeExtent extent = extent_of(nodes);
    board.columns = extent.columns();
    board.rows = extent.rows();
}

std::string family_text(const MarkerFamily& family, std::size_t agreeing) {
    return family.name + ", " + std::to_string(agreeing) + " of " +
           std::to_string(family.markers.size()) + " markers agree";
}

/// A chessboard; with markers in its bright cells it is a ChArUco board.
std::optional<BoardDetection> chessboard_in(const GrayImage& picture, BoardKind kind,
                                            std::string& reason) {
    ChessboardPattern pattern = find_chessboard(picture);
    if (pattern.nodes.empty()) {
        reason = std::to_string(pattern.candidates) +
                 " points look like chessboard corners, but no 3 x 3 of them form a pattern";
        return std::nullopt;
    }
    BoardDetection board;
    board.kind = BoardKind::kChessboard;
    const std::vector<DarkQuad> quads = detect_dark_quads(picture);
    const MarkerFamily family = read_markers(picture, quads);
    if (const auto layout = charuco_layout(pattern.nodes, quads, family)) {
        board.kind = BoardKind::kCharuco;
        board.markers = family_text(family, layout->markers);
        if (layout->columns > 0) {
            board.markers += ", " + std::to_string(layout->columns) +
                             " cells in a row, the first " +
                             (layout->is_first_cell_bright ? "bright" : "dark");
        }
    }
    if (board.kind == BoardKind::kCharuco || kind == BoardKind::kCharuco) {
        pattern = find_chessboard_with_markers(picture);
    }
    board.step_px = pattern.median_step_px;
    take_points(pattern.nodes, LatticeShape::kSquare, board.view);
    take_extent(pattern.nodes, board);
    return board;
}

/// What is left of a grid of markers when those go whose number does not fit their place.
std::optional<MarkerGridLayout> keep_agreeing(GridPattern& pattern, const std::vector<int>& ids) {
    const auto layout = marker_grid_layout(pattern.nodes, ids);
    if (!layout) return std::nullopt;
    std::vector<PatternNode> kept;
    for (std::size_t index = 0; index < pattern.nodes.size(); ++index) {
        if (layout->agrees[index]) kept.push_back(std::move(pattern.nodes[index]));
    }
    pattern.nodes = std::move(kept);
    return layout;
}

/// A grid of squares; where they are markers, those alone.
std::optional<BoardDetection> square_grid_in(const GrayImage& picture, BoardKind kind,
                                             std::string& reason) {
    const std::vector<DarkQuad> quads = detect_dark_quads(picture);
    const MarkerFamily family = read_markers(picture, quads);
    BoardDetection board;
    board.kind = BoardKind::kSquareGrid;
    GridPattern pattern;
    if (!family.markers.empty()) {
        std::vector<DarkQuad> markers;
        for (const MarkerReading& marker : family.markers) markers.push_back(quads[marker.quad]);
        pattern = find_square_grid(markers);
        std::vector<int> ids;
        for (const std::size_t marker : pattern.shape_of_node) {
            ids.push_back(family.markers[marker].id);
        }
        if (const auto layout = keep_agreeing(pattern, ids)) {
            board.kind = BoardKind::kAprilGrid;
            board.markers = family_text(family, layout->markers);
            if (layout->columns > 1) {
                board.markers += ", " + std::to_string(layout->columns) + " in a row";
            }
        } else {
            pattern = {};
        }
    }
    if (pattern.nodes.empty() && kind != BoardKind::kAprilGrid) pattern = find_square_grid(quads);
    if (pattern.nodes.empty()) {
        reason = std::to_string(quads.size()) + " dark four-sided shapes were found, " +
                 std::to_string(family.markers.size()) + " of them markers, but no regular grid";
        return std::nullopt;
    }
    board.step_px = pattern.median_step_px;
    board.size_per_pitch = pattern.size_per_pitch;
    take_points(pattern.nodes, pattern.shape, board.view);
    take_extent(pattern.nodes, board);
    return board;
}

std::optional<BoardDetection> circles_in(const GrayImage& picture, std::string& reason) {
    const std::vector<DiscImage> discs = detect_discs(picture);
    const GridPattern pattern = find_circle_grid(discs);
    if (pattern.nodes.empty()) {
        reason =
            std::to_string(discs.size()) + " round shapes were found, but no regular grid of them";
        return std::nullopt;
    }
    BoardDetection board;
    board.kind = BoardKind::kCircles;
    if (pattern.shape == LatticeShape::kHexagonal) {
        board.kind = BoardKind::kHexagonalCircles;
    } else if (stands_on_a_corner(pattern.nodes)) {
        board.kind = BoardKind::kAsymmetricCircles;
    }
    board.step_px = pattern.median_step_px;
    board.size_per_pitch = pattern.size_per_pitch;
    take_points(pattern.nodes, pattern.shape, board.view);
    take_extent(pattern.nodes, board);
    return board;
}

bool is_circles(BoardKind kind) {
    return kind == BoardKind::kCircles || kind == BoardKind::kAsymmetricCircles ||
           kind == BoardKind::kHexagonalCircles;
}

/// Where the size is said, a larger pattern is another one.
bool is_larger_than_said(const BoardDetection& board, const BoardRequest& request) {
    if (request.columns == 0 || request.rows == 0 || !has_definite_size(board.kind)) return false;
    const auto [less, more] = std::minmax(board.columns, board.rows);
    const auto [said_less, said_more] = std::minmax(request.columns, request.rows);
    return less > said_less || more > said_more;
}

}  // namespace

BoardAnswer detect_board(const GrayImage& picture, const std::string& name, BoardKind kind,
                         const BoardRequest& request) {
    std::string reason;
    BoardAnswer answer;
    if (is_circles(kind)) {
        answer.board = circles_in(picture, reason);
    } else if (kind == BoardKind::kSquareGrid || kind == BoardKind::kAprilGrid) {
        answer.board = square_grid_in(picture, kind, reason);
    } else {
        answer.board = chessboard_in(picture, kind, reason);
    }
    if (!answer.board) {
        const std::string fault = picture_fault(picture);
        if (!fault.empty()) reason += "; " + fault;
        answer.left_out = {name, "E-BOARD-NOTFOUND", reason};
        return answer;
    }
    if (is_larger_than_said(*answer.board, request)) {
        answer.left_out = {name, "E-BOARD-LARGER",
                           "a pattern of " + std::to_string(answer.board->columns) + " x " +
                               std::to_string(answer.board->rows) +
                               " was found, larger than the board that was described"};
        answer.board.reset();
        return answer;
    }
    answer.board->view.photograph = name;
    return answer;
}

}  // namespace lumi
