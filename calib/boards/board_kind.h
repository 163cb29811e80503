#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace lumi {

/// The printed patterns that lenses are calibrated with.
enum class BoardKind {
    kChessboard,
    kCharuco,            ///< A chessboard with a marker in each bright cell.
    kAprilGrid,          ///< Markers on a square lattice.
    kSquareGrid,         ///< Plain dark squares, apart.
    kCircles,            ///< Discs on a square lattice, in rows and columns.
    kAsymmetricCircles,  ///< The same standing on a corner: every other row is shifted.
    kHexagonalCircles,   ///< Each disc has six neighbours at 60 degrees.
};

constexpr std::array<BoardKind, 7> kBoardKinds{
    BoardKind::kChessboard,      BoardKind::kCharuco, BoardKind::kAprilGrid,
    BoardKind::kSquareGrid,      BoardKind::kCircles, BoardKind::kAsymmetricCircles,
    BoardKind::kHexagonalCircles};

/// "chessboard", "charuco", "aprilgrid", "squares", "circles", "asymmetric-circles",
/// "hexagonal-circles".
[[nodiscard]] std::string_view name_of(BoardKind kind);
[[nodiscard]] std::optional<BoardKind> board_kind_named(std::string_view name);
/// Whether columns and rows can be counted in one way only: not those of shifted and hexagonal
/// circles.
[[nodiscard]] bool has_definite_size(BoardKind kind);
/// All names, for messages.
[[nodiscard]] std::string board_kind_names();

}  // namespace lumi
