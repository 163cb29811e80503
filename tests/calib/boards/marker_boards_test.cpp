#include "tests/calib/boards/marker_boards.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

const Camera kMarkerLens{800, 600, LensModel::kSimpleRadial, {700, 402, 297, -0.12}};

/// What detection and calibration make of photographs of a print.
struct Outcome {
    std::vector<BoardDetection> detections;
    BoardCalibration calibration;
};

Outcome calibrate(const BoardPrint& print, int columns, int rows, BoardKind way) {
    SilentProgress progress;
    Outcome outcome;
    BoardViews board;
    board.width_px = kMarkerLens.width_px;
    board.height_px = kMarkerLens.height_px;
    std::uint32_t seed = 1;
    for (const BoardPose& pose : hand_held_poses(kMarkerLens, columns, rows, 8, 40, 21)) {
        const BoardAnswer answer = detect_board(
            photograph_of(print, kMarkerLens, pose, {.noise = 2, .seed = seed++}), "p", way, {});
        EXPECT_TRUE(answer.board) << answer.left_out.reason;
        if (!answer.board) continue;
        board.views.push_back(answer.board->view);
        board.size_per_pitch = answer.board->size_per_pitch;
        outcome.detections.push_back(*answer.board);
    }
    outcome.calibration = calibrate_boards(board, {}, progress);
    return outcome;
}

class CharucoLayouts : public testing::TestWithParam<bool> {};

TEST_P(CharucoLayouts, AreToldApartAndCalibrateTheLens) {
    const bool is_first_cell_bright = GetParam();
    const Outcome outcome =
        calibrate(printed_charuco(9, 6, 0.75, is_first_cell_bright), 8, 5, BoardKind::kChessboard);
    const std::string said =
        std::string("9 cells in a row, the first ") + (is_first_cell_bright ? "bright" : "dark");
    int told = 0;
    for (const BoardDetection& detection : outcome.detections) {
        EXPECT_EQ(name_of(detection.kind), "charuco");
        EXPECT_GE(detection.view.points.size(), 30u);
        // A part without both ends of a row does not tell how rows are numbered.
        if (detection.markers.find("cells in a row") == std::string::npos) continue;
        EXPECT_THAT(detection.markers, HasSubstr(said));
        ++told;
    }
    EXPECT_GE(told, 3);
    EXPECT_NEAR(outcome.calibration.lens.parameters[0], 700, 0.003 * 700);
    EXPECT_LT(outcome.calibration.rms_px, 0.15);
}

INSTANTIATE_TEST_SUITE_P(Layouts, CharucoLayouts, testing::Bool());

TEST(Charuco, APartOfTheBoardIsEnough) {
    const BoardPose near = {0.1, -0.4, 0.3, -3.5, -2.0, 4.5};
    const BoardAnswer answer =
        detect_board(photograph_of(printed_charuco(9, 6, 0.7, false), kMarkerLens, near), "p",
                     BoardKind::kCharuco, {});
    ASSERT_TRUE(answer.board) << answer.left_out.reason;
    EXPECT_EQ(answer.board->kind, BoardKind::kCharuco);
    EXPECT_LT(answer.board->view.points.size(), 40u);
}

TEST(Charuco, LargeMarkersAreNotTakenForAGridOfSquares) {
    const ScratchFolder folder;
    int index = 0;
    for (const BoardPose& pose : hand_held_poses(kMarkerLens, 10, 7, 4, 40, 21)) {
        write_png(folder.path() / (std::to_string(index++) + ".png"),
                  photograph_of(printed_charuco(11, 8, 0.8, false), kMarkerLens, pose));
    }
    SilentProgress progress;
    EXPECT_EQ(name_of(find_boards(folder.path(), {}, 0, progress).kind), "charuco");
}

struct GridPrint {
    int border_bits;
    bool has_corner_squares;
};

class AprilGrids : public testing::TestWithParam<GridPrint> {};

TEST_P(AprilGrids, AreReadAndCalibrateTheLens) {
    const Outcome outcome = calibrate(
        printed_aprilgrid(6, 5, 0.77, GetParam().border_bits, GetParam().has_corner_squares), 6, 5,
        BoardKind::kSquareGrid);
    for (const BoardDetection& detection : outcome.detections) {
        EXPECT_EQ(name_of(detection.kind), "aprilgrid");
        EXPECT_THAT(detection.markers, HasSubstr("36h11"));
        EXPECT_THAT(detection.markers, HasSubstr("6 in a row"));
        EXPECT_GE(detection.view.points.size(), 4u * 20u);
    }
    EXPECT_NEAR(outcome.calibration.lens.parameters[0], 700, 0.003 * 700);
    EXPECT_NEAR(outcome.calibration.size_per_pitch, 0.77, 0.02);
    EXPECT_LT(outcome.calibration.rms_px, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Prints, AprilGrids,
                         testing::Values(GridPrint{1, false}, GridPrint{2, false},
                                         GridPrint{2, true}));

TEST(AprilGrid, NarrowGapsBetweenMarkersDoNotMoveTheirCorners) {
    const Outcome outcome =
        calibrate(printed_aprilgrid(6, 5, 0.9, 1, false), 6, 5, BoardKind::kSquareGrid);
    for (const BoardDetection& detection : outcome.detections) {
        EXPECT_EQ(name_of(detection.kind), "aprilgrid");
        EXPECT_GE(detection.view.points.size(), 4u * 20u);
    }
    EXPECT_NEAR(outcome.calibration.lens.parameters[0], 700, 0.003 * 700);
    EXPECT_LT(outcome.calibration.rms_px, 0.15);
}

}  // namespace
}  // namespace lumi
