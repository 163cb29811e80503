#include "calib/boards/board_detection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "calib/boards/board_calibration.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/boards/synthetic_boards.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

const Camera kLens{640, 480, LensModel::kSimpleRadial, {560, 322, 237, -0.12}};

/// A board of `columns` by `rows` nodes, turned and tilted, in the middle of the picture.
BoardPose pose_of(int columns, int rows, double turn_deg, double tilt_deg, double depth) {
    const double radians = std::numbers::pi / 180;
    const Eigen::Matrix3d rotation =
        (Eigen::AngleAxisd(tilt_deg * radians, Eigen::Vector3d(0.6, 0.8, 0)) *
         Eigen::AngleAxisd(turn_deg * radians, Eigen::Vector3d::UnitZ()))
            .toRotationMatrix();
    const Eigen::AngleAxisd turn(rotation);
    const Eigen::Vector3d vector = turn.angle() * turn.axis();
    const Eigen::Vector3d place =
        Eigen::Vector3d(0, 0, depth) -
        rotation * Eigen::Vector3d(0.5 * (columns - 1), 0.5 * (rows - 1), 0);
    return {vector.x(), vector.y(), vector.z(), place.x(), place.y(), place.z()};
}

/// Root mean square of the distances of the points to the nearest true one; far ones count as such.
double rms_to_truth_px(const BoardView& view, const BoardPose& pose,
                       const std::vector<Eigen::Vector2d>& places) {
    double sum = 0;
    for (const BoardPoint& point : view.points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Eigen::Vector2d& place : places) {
            nearest = std::min(nearest, (seen_at(kLens, pose, place) - point.px).squaredNorm());
        }
        sum += nearest;
    }
    return std::sqrt(sum / static_cast<double>(view.points.size()));
}

std::vector<Eigen::Vector2d> grid_of(int columns, int rows) {
    std::vector<Eigen::Vector2d> places;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) places.emplace_back(column, row);
    }
    return places;
}

BoardAnswer chessboard_in(const GrayImage& picture) {
    return detect_board(picture, "p", BoardKind::kChessboard, {});
}

struct BoardPlace {
    int columns;
    int rows;
    double turn_deg;
    double tilt_deg;
    double depth;
};

class Chessboards : public testing::TestWithParam<BoardPlace> {};

TEST_P(Chessboards, AreFoundWholeToAFractionOfAPixel) {
    const BoardPlace& at = GetParam();
    const BoardPose pose = pose_of(at.columns, at.rows, at.turn_deg, at.tilt_deg, at.depth);
    const BoardAnswer answer =
        chessboard_in(photograph_of(printed_chessboard(at.columns, at.rows), kLens, pose));
    ASSERT_TRUE(answer.board) << answer.left_out.reason;
    EXPECT_EQ(answer.board->view.points.size(), static_cast<std::size_t>(at.columns * at.rows));
    EXPECT_EQ(std::minmax({answer.board->columns, answer.board->rows}),
              std::minmax({at.columns, at.rows}));
    EXPECT_LT(rms_to_truth_px(answer.board->view, pose, grid_of(at.columns, at.rows)), 0.06);
}

INSTANTIATE_TEST_SUITE_P(Places, Chessboards,
                         testing::Values(BoardPlace{9, 6, 4, 0, 12}, BoardPlace{9, 6, 45, 20, 12},
                                         BoardPlace{9, 6, 90, 30, 14},
                                         BoardPlace{9, 6, 180, 45, 11},
                                         BoardPlace{9, 6, 263, 55, 12}, BoardPlace{3, 3, 10, 30, 6},
                                         BoardPlace{4, 11, 30, 25, 16},
                                         BoardPlace{17, 12, 5, 30, 20},
                                         BoardPlace{9, 6, 20, 30, 35}));

TEST(Chessboard, PartsBlurAndGlareStillGiveTrueCorners) {
    const std::vector<Eigen::Vector2d> places = grid_of(9, 6);
    const BoardPrint print = printed_chessboard(9, 6);
    const BoardPose near = pose_of(9, 6, 30, 30, 6);
    const BoardAnswer part = chessboard_in(photograph_of(print, kLens, near));
    ASSERT_TRUE(part.board);
    EXPECT_LT(part.board->view.points.size(), 54u);
    EXPECT_GE(part.board->view.points.size(), 20u);
    EXPECT_LT(rms_to_truth_px(part.board->view, near, places), 0.06);

    const BoardPose pose = pose_of(9, 6, 30, 30, 11);
    const BoardAnswer blurred = chessboard_in(photograph_of(print, kLens, pose, {.blur_px = 4}));
    ASSERT_TRUE(blurred.board);
    EXPECT_GE(blurred.board->view.points.size(), 50u);
    EXPECT_LT(rms_to_truth_px(blurred.board->view, pose, places), 0.2);

    const BoardAnswer glare = chessboard_in(photograph_of(print, kLens, pose, {.has_glare = true}));
    ASSERT_TRUE(glare.board);
    EXPECT_GE(glare.board->view.points.size(), 35u);
    // Glare moves the edges that it leaves.
    EXPECT_LT(rms_to_truth_px(glare.board->view, pose, places), 0.3);
}

TEST(Chessboard, WhatIsNoBoardIsRejectedWithAReason) {
    const BoardAnswer plain = chessboard_in(GrayImage(640, 480, 128));
    EXPECT_FALSE(plain.board);
    EXPECT_EQ(plain.left_out.code, "E-BOARD-NOTFOUND");
    EXPECT_THAT(plain.left_out.reason, HasSubstr("blurred, or has no contrast"));
    EXPECT_THAT(chessboard_in(GrayImage(640, 480, 12)).left_out.reason, HasSubstr("too dark"));
    EXPECT_THAT(chessboard_in(GrayImage(640, 480, 255)).left_out.reason, HasSubstr("overexposed"));
    EXPECT_FALSE(chessboard_in(GrayImage(4, 4, 128)).board);
}

TEST(BoardDetection, ThinPicturesHoldNoBoard) {
    for (const BoardKind kind :
         {BoardKind::kChessboard, BoardKind::kSquareGrid, BoardKind::kCircles}) {
        EXPECT_EQ(detect_board(GrayImage(1, 5000, 90), "p", kind, {}).left_out.code,
                  "E-BOARD-NOTFOUND");
        EXPECT_EQ(detect_board(GrayImage(5000, 2, 90), "p", kind, {}).left_out.code,
                  "E-BOARD-NOTFOUND");
    }
}

TEST(Chessboard, ALargerPatternThanSaidIsAnotherBoard) {
    const GrayImage picture =
        photograph_of(printed_chessboard(9, 6), kLens, pose_of(9, 6, 10, 20, 12));
    const BoardAnswer answer =
        detect_board(picture, "p", BoardKind::kChessboard, {.kind = {}, .columns = 7, .rows = 5});
    EXPECT_FALSE(answer.board);
    EXPECT_EQ(answer.left_out.code, "E-BOARD-LARGER");
    EXPECT_TRUE(
        detect_board(picture, "p", BoardKind::kChessboard, {.kind = {}, .columns = 6, .rows = 9})
            .board);
}

TEST(SquareGrid, CornersAreFoundAndTheSizeIsMeasured) {
    const BoardPose pose = pose_of(6, 4, 25, 35, 8);
    const BoardAnswer answer = detect_board(photograph_of(printed_squares(6, 4, 0.6), kLens, pose),
                                            "p", BoardKind::kSquareGrid, {});
    ASSERT_TRUE(answer.board) << answer.left_out.reason;
    EXPECT_EQ(answer.board->view.points.size(), 96u);
    EXPECT_NEAR(answer.board->size_per_pitch, 0.6, 0.02);
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector2d& centre : grid_of(6, 4)) {
        for (const double x : {-0.3, 0.3}) {
            for (const double y : {-0.3, 0.3}) corners.push_back(centre + Eigen::Vector2d(x, y));
        }
    }
    EXPECT_LT(rms_to_truth_px(answer.board->view, pose, corners), 0.25);
}

TEST(SquareGrid, AChessboardIsNone) {
    EXPECT_FALSE(
        detect_board(photograph_of(printed_chessboard(9, 6), kLens, pose_of(9, 6, 10, 20, 12)), "p",
                     BoardKind::kSquareGrid, {})
            .board);
}

std::vector<Eigen::Vector2d> circle_places(BoardKind kind) {
    std::vector<Eigen::Vector2d> places;
    for (int row = 0; row < 9; ++row) {
        for (int column = 0; column < 7; ++column) {
            if (kind == BoardKind::kCircles) {
                places.emplace_back(column, row);
            } else if (kind == BoardKind::kAsymmetricCircles) {
                // OpenCV's: ((2 column + row % 2) s, row s); neighbours are sqrt(2) s apart.
                places.emplace_back((2 * column + row % 2) / std::numbers::sqrt2,
                                    row / std::numbers::sqrt2);
            } else {
                places.emplace_back(column + 0.5 * (row % 2), row * std::numbers::sqrt3 / 2);
            }
        }
    }
    return places;
}

class CircleGrids : public testing::TestWithParam<BoardKind> {};

TEST_P(CircleGrids, AreToldApartAndCalibrateTheLens) {
    const std::vector<Eigen::Vector2d> places = circle_places(GetParam());
    const BoardPrint print = printed_discs(places, 0.6);
    SilentProgress progress;
    int as_printed = 0;
    BoardViews board;
    board.width_px = kLens.width_px;
    board.height_px = kLens.height_px;
    board.are_discs = true;
    board.size_per_pitch = 0.6;
    for (const BoardPose& pose : hand_held_poses(kLens, 8, 8, 8, 40, 4)) {
        const BoardAnswer answer =
            detect_board(photograph_of(print, kLens, pose), "p", BoardKind::kCircles, {});
        ASSERT_TRUE(answer.board) << answer.left_out.reason;
        as_printed += answer.board->kind == GetParam() ? 1 : 0;
        EXPECT_NEAR(answer.board->size_per_pitch, 0.6, 0.03);
        board.views.push_back(answer.board->view);
    }
    // A part of a shifted grid may look like one in rows and columns: the others outvote it.
    EXPECT_GE(as_printed, 6);
    const BoardCalibration found = calibrate_boards(board, {}, progress);
    EXPECT_NEAR(found.lens.parameters[0], 560, 0.002 * 560);
    EXPECT_LT(found.rms_px, 0.08);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CircleGrids,
                         testing::Values(BoardKind::kCircles, BoardKind::kAsymmetricCircles,
                                         BoardKind::kHexagonalCircles));

/// A folder of photographs of one print.
void put_photographs(const ScratchFolder& folder, const BoardPrint& print, int columns, int rows,
                     int count) {
    int index = 0;
    for (const BoardPose& pose : hand_held_poses(kLens, columns, rows, count, 40, 11)) {
        write_png(folder / ("photo " + std::to_string(index++) + ".png"),
                  photograph_of(print, kLens, pose));
    }
}

TEST(BoardPhotographs, TheKindOfBoardIsFound) {
    SilentProgress progress;
    const ScratchFolder chessboards;
    put_photographs(chessboards, printed_chessboard(9, 6), 9, 6, 4);
    EXPECT_EQ(find_boards(chessboards.path(), {}, 0, progress).kind, BoardKind::kChessboard);
    const ScratchFolder squares;
    put_photographs(squares, printed_squares(6, 4, 0.5), 6, 4, 4);
    EXPECT_EQ(find_boards(squares.path(), {}, 0, progress).kind, BoardKind::kSquareGrid);
    const ScratchFolder circles;
    put_photographs(circles, printed_discs(grid_of(7, 5), 0.5), 7, 5, 4);
    const BoardPhotographs found = find_boards(circles.path(), {}, 0, progress);
    EXPECT_EQ(found.kind, BoardKind::kCircles);
    EXPECT_EQ(found.columns, 7);
    EXPECT_EQ(found.rows, 5);
}

TEST(BoardPhotographs, ASizeThatNoPhotographShowsIsDoubted) {
    SilentProgress progress;
    const ScratchFolder folder;
    put_photographs(folder, printed_chessboard(9, 6), 9, 6, 3);
    const auto warnings_for = [&](int columns, int rows) {
        return find_boards(folder.path(), {.kind = {}, .columns = columns, .rows = rows}, 0,
                           progress)
            .warnings;
    };
    EXPECT_THAT(warnings_for(0, 0), testing::IsEmpty());
    EXPECT_THAT(warnings_for(9, 6), testing::IsEmpty());
    EXPECT_THAT(warnings_for(6, 9), testing::IsEmpty());
    EXPECT_THAT(warnings_for(9, 12), testing::ElementsAre(HasSubstr("12 x 9 was said, and no")));
}

TEST(BoardPhotographs, ASizeIsNotUsedWhereRowsAreCountedInSeveralWays) {
    SilentProgress progress;
    const ScratchFolder folder;
    std::vector<Eigen::Vector2d> shifted;
    for (int row = 0; row < 9; ++row) {
        for (int column = 0; column < 5; ++column) {
            shifted.emplace_back(column + 0.5 * (row % 2), 0.5 * row);
        }
    }
    put_photographs(folder, printed_discs(shifted, 0.3), 5, 5, 3);
    const BoardPhotographs found =
        find_boards(folder.path(), {.kind = {}, .columns = 2, .rows = 2}, 0, progress);
    EXPECT_EQ(found.kind, BoardKind::kAsymmetricCircles);
    EXPECT_THAT(found.warnings, testing::ElementsAre(HasSubstr("was not used")));
}

TEST(BoardPhotographs, OneThatOpenCvCannotLookAtIsLeftOut) {
    const ScratchFolder folder;
    // Narrower than the window in which corners are refined.
    GrayImage picture(8, 14, 220);
    for (int y = 2; y < 12; ++y) {
        for (int x = 1; x < 7; ++x) picture(x, y) = 20;
    }
    write_png(folder / "tiny.png", picture);
    SilentProgress progress;
    try {
        (void)find_boards(folder.path(), {.kind = BoardKind::kSquareGrid}, 1, progress);
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-BOARDS-NOTFOUND");
        EXPECT_THAT(error.what(), HasSubstr("tiny.png: OpenCV cannot look at it"));
    }
}

std::string code_of_refusal(const std::filesystem::path& folder) {
    SilentProgress progress;
    try {
        (void)find_boards(folder, {}, 0, progress);
    } catch (const Error& error) {
        EXPECT_FALSE(error.advice().empty());
        return error.code();
    }
    return "";
}

TEST(BoardPhotographs, FoldersThatCannotDoAreRefusedByName) {
    const ScratchFolder folder;
    EXPECT_EQ(code_of_refusal(folder / "nowhere"), "E-INGEST-NOFOLDER");
    EXPECT_EQ(code_of_refusal(folder.path()), "E-BOARDS-NOPHOTOS");
    write_png(folder / "a.png", GrayImage(640, 480, 90));
    EXPECT_EQ(code_of_refusal(folder.path()), "E-BOARDS-NOTFOUND");
    write_png(folder / "c.png", GrayImage(480, 640, 90));
    EXPECT_EQ(code_of_refusal(folder.path()), "E-BOARDS-SIZES");
}

}  // namespace
}  // namespace lumi
