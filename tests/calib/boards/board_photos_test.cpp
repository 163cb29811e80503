#include <gtest/gtest.h>

#include <cmath>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/lens_files/lens_files.h"
#include "tests/calib/photographs.h"

namespace lumi {
namespace {

struct BoardSet {
    const char* folder;  ///< Below boofcv/calibration.
    BoardKind kind;
    std::size_t least_used;
    double max_held_out_px;
    double max_focal_deviation;  ///< From intrinsic.yaml, as a share; 0: there is none.
};

class RealBoards : public testing::TestWithParam<BoardSet> {};

TEST_P(RealBoards, AreFoundAndCalibrateTheLens) {
    const std::filesystem::path folder =
        photographs_folder() / "boofcv/calibration" / GetParam().folder;
    if (!std::filesystem::exists(folder)) {
        GTEST_SKIP() << folder << " is not there; set LUMI_PHOTOS to run this test";
    }
    SilentProgress progress;
    const BoardPhotographs found = find_boards(folder, {}, 0, progress);
    EXPECT_EQ(name_of(found.kind), name_of(GetParam().kind));
    const BoardCalibration calibration = calibrate_boards(found.board, {}, progress);
    EXPECT_GE(calibration.views.size(), GetParam().least_used);
    EXPECT_LE(calibration.held_out_rms_px.value(), GetParam().max_held_out_px);
    if (GetParam().max_focal_deviation == 0) return;
    const double reference = focal_length_px(read_lens_file(folder / "intrinsic.yaml")).mean();
    const double ours = focal_length_px(calibration.lens).mean();
    EXPECT_LE(std::abs(ours - reference), GetParam().max_focal_deviation * reference);
    EXPECT_LE(std::abs(ours - reference), 3 * calibration.parameters.front().sigma);
}

// Zhang's five photographs are held against 832.5 px in his own paper (A flexible new technique for
// camera calibration, 2000), 1.1 % from the file beside them: hence the wider bound. The Sony's
// chessboard covers little of the picture: with its bow, its focal length is uncertain by 1.6 %.
INSTANTIATE_TEST_SUITE_P(
    Sets, RealBoards,
    testing::Values(BoardSet{"mono/PULNiX_CCD_6mm_Zhang", BoardKind::kSquareGrid, 5, 0.5, 0.012},
                    BoardSet{"mono/Sony_DSC-HX5V_Chess", BoardKind::kChessboard, 12, 0.3, 0.012},
                    BoardSet{"mono/Sony_DSC-HX5V_Square", BoardKind::kSquareGrid, 12, 0.4, 0.005},
                    BoardSet{"mono/Sony_DSC-HX5V_CircleHexagonal", BoardKind::kHexagonalCircles, 7,
                             0.4, 0},
                    BoardSet{"mono/Sony_DSC-HX5V_CircleRegular", BoardKind::kCircles, 6, 0.6, 0},
                    BoardSet{"fisheye/chessboard", BoardKind::kChessboard, 24, 0.3, 0},
                    BoardSet{"fisheye/square_grid", BoardKind::kSquareGrid, 14, 0.5, 0}));

}  // namespace
}  // namespace lumi
