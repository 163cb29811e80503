#include "calib/boards/board_kind.h"

namespace lumi {

std::string_view name_of(BoardKind kind) {
    switch (kind) {
        case BoardKind::kChessboard:
            return "chessboard";
        case BoardKind::kCharuco:
            return "charuco";
        case BoardKind::kAprilGrid:
            return "aprilgrid";
        case BoardKind::kSquareGrid:
            return "squares";
        case BoardKind::kCircles:
            return "circles";
        case BoardKind::kAsymmetricCircles:
            return "asymmetric-circles";
        case BoardKind::kHexagonalCircles:
            break;
    }
    return "hexagonal-circles";
}

std::optional<BoardKind> board_kind_named(std::string_view name) {
    for (const BoardKind kind : kBoardKinds) {
        if (name_of(kind) == name) return kind;
    }
    return std::nullopt;
}

bool has_definite_size(BoardKind kind) {
    return kind != BoardKind::kAsymmetricCircles && kind != BoardKind::kHexagonalCircles;
}

std::string board_kind_names() {
    std::string names;
    for (const BoardKind kind : kBoardKinds) {
        names += (names.empty() ? "" : ", ") + std::string(name_of(kind));
    }
    return names;
}

}  // namespace lumi
