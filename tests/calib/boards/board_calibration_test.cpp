#include "calib/boards/board_calibration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "calib/boards/board_pose.h"
#include "calib/boards/calibration_evidence.h"
#include "tests/calib/boards/synthetic_boards.h"

namespace lumi {
namespace {

using testing::HasSubstr;

Camera lens_named(const std::string& name) {
    if (name == "SIMPLE_PINHOLE") return {640, 480, LensModel::kSimplePinhole, {560, 322, 237}};
    if (name == "PINHOLE") return {640, 480, LensModel::kPinhole, {560, 572, 322, 237}};
    if (name == "SIMPLE_RADIAL") {
        return {640, 480, LensModel::kSimpleRadial, {560, 322, 237, -0.12}};
    }
    if (name == "RADIAL") return {640, 480, LensModel::kRadial, {560, 322, 237, -0.3, 0.15}};
    if (name == "OPENCV") {
        return {640, 480, LensModel::kOpenCv, {560, 566, 322, 237, -0.3, 0.12, 0.004, -0.003}};
    }
    return {640, 480, LensModel::kOpenCvFisheye, {200, 203, 322, 237, 0.02, -0.01, 0.004, -0.001}};
}

BoardCalibration calibrate(const BoardViews& board, const BoardCalibrationOptions& options = {}) {
    SilentProgress progress;
    return calibrate_boards(board, options, progress);
}

std::string code_of_refusal(const BoardViews& board) {
    try {
        (void)calibrate(board);
    } catch (const Error& error) {
        EXPECT_FALSE(error.advice().empty());
        return error.code();
    }
    return "";
}

class EveryLens : public testing::TestWithParam<const char*> {};

TEST_P(EveryLens, IsFoundAgainFromExactPoints) {
    const Camera truth = lens_named(GetParam());
    const BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 14, 40, 3), 0.0, 1);
    const BoardCalibration found = calibrate(board, {.models = {truth.model}});
    ASSERT_EQ(found.lens.parameters.size(), truth.parameters.size());
    for (std::size_t index = 0; index < truth.parameters.size(); ++index) {
        EXPECT_NEAR(found.lens.parameters[index], truth.parameters[index],
                    1e-6 * std::max(1.0, std::abs(truth.parameters[index])))
            << index;
    }
    EXPECT_LT(found.rms_px, 1e-6);
}

TEST_P(EveryLens, IsTheModelThatIsChosenFromNoisyPoints) {
    const Camera truth = lens_named(GetParam());
    const BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 16, 40, 5), 0.15, 2);
    const BoardCalibration found = calibrate(board);
    EXPECT_EQ(name_of(found.lens.model), name_of(truth.model));
    EXPECT_NEAR(focal_length_px(found.lens).x(), focal_length_px(truth).x(),
                4 * found.parameters[0].sigma);
    EXPECT_NEAR(found.rms_px, 0.15 * std::sqrt(2.0), 0.02);
}

INSTANTIATE_TEST_SUITE_P(Models, EveryLens,
                         testing::Values("SIMPLE_PINHOLE", "PINHOLE", "SIMPLE_RADIAL", "RADIAL",
                                         "OPENCV", "OPENCV_FISHEYE"));

TEST(BoardCalibration, SeesBeyondNinetyDegrees) {
    const Camera truth{800, 800, LensModel::kOpenCvFisheye, {230, 230, 402, 397, 0.01, 0, 0, 0}};
    std::vector<BoardPose> poses = hand_held_poses(truth, 9, 6, 10, 30, 3);
    // Boards that reach behind the camera's plane.
    for (int index = 0; index < 4; ++index) {
        const double side = index % 2 == 0 ? 1.0 : -1.0;
        poses.push_back({0.1, side * 1.35, 0.05 * index, side * -6.0, -2.5, 0.2});
    }
    const BoardViews board = seen_chessboards(truth, 9, 6, poses, 0.0, 1);
    double widest_deg = 0;
    for (std::size_t view = 0; view < board.views.size(); ++view) {
        for (const BoardPoint& point : board.views[view].points) {
            widest_deg = std::max(
                widest_deg, (point.px - principal_point_px(truth)).norm() / 230 * 180 / 3.14159);
        }
    }
    ASSERT_GT(widest_deg, 91.0);
    const BoardCalibration found = calibrate(board, {.models = {LensModel::kOpenCvFisheye}});
    EXPECT_NEAR(found.lens.parameters[0], 230, 1e-4);
}

TEST(BoardCalibration, ParametersThatSayNothingAreNotKept) {
    const Camera truth = lens_named("SIMPLE_RADIAL");
    const BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 16, 40, 8), 0.2, 4);
    const BoardCalibration found = calibrate(board, {.models = {LensModel::kFullOpenCv}});
    EXPECT_LE(free_parameters(found.form), 5);
    EXPECT_FALSE(found.dropped.empty());
}

TEST(BoardCalibration, HeldOutErrorIsThatOfRefitsWithoutThePhotograph) {
    const Camera truth = lens_named("RADIAL");
    const BoardViews board =
        seen_chessboards(truth, 7, 5, hand_held_poses(truth, 7, 5, 8, 35, 6), 0.3, 3);
    const BoardCalibration found = calibrate(board, {.models = {LensModel::kRadial}});
    const BoardSolution start{all_free(LensModel::kRadial), found.lens, 0.0, {}};
    for (std::size_t out = 0; out < board.views.size(); ++out) {
        BoardViews others = board;
        BoardSolution solution = start;
        others.views.erase(others.views.begin() + static_cast<std::ptrdiff_t>(out));
        for (const BoardView& view : others.views) {
            solution.cam_from_board.push_back(
                solve_board_pose(view, in_model(found.lens, LensModel::kSimplePinhole), 0.0)
                    ->cam_from_board);
        }
        const LensFit refit = fit_lens(others, solution);
        const auto rough = solve_board_pose(board.views[out],
                                            in_model(found.lens, LensModel::kSimplePinhole), 0.0);
        const auto solved =
            solve_board_pose(board.views[out], refit.solution.lens, 0.0, rough->cam_from_board);
        EXPECT_NEAR(found.views[out].held_out_rms_px.value(), solved->rms_px,
                    0.02 * solved->rms_px);
    }
}

TEST(BoardCalibration, NoErrorIsStatedForPhotographsThatCannotBePredicted) {
    const Camera truth = lens_named("RADIAL");
    const std::vector<BoardPose> poses = hand_held_poses(truth, 7, 5, 4, 35, 6);
    const BoardViews board = seen_chessboards(truth, 7, 5, poses, 0.3, 3);
    BoardCalibration result;
    add_evidence(board, {all_free(truth.model), truth, 0.0, poses}, {}, result);
    EXPECT_GT(result.rms_px, 0.0);
    EXPECT_FALSE(result.held_out_rms_px.has_value());
    for (const CalibratedView& view : result.views) EXPECT_FALSE(view.held_out_rms_px.has_value());
}

TEST(BoardCalibration, StatedIntervalsHoldTheTruthAsOftenAsTheySay) {
    constexpr int kTrials = 200;
    int held = 0;
    for (int trial = 0; trial < kTrials; ++trial) {
        const auto seed = static_cast<std::uint32_t>(trial);
        const Camera truth{
            640, 480, LensModel::kRadial, {520.0 + trial, 315.0 + 0.1 * trial, 240, -0.25, 0.1}};
        const BoardViews board = seen_chessboards(
            truth, 6, 4, hand_held_poses(truth, 6, 4, 10, 40, 1000 + seed), 0.2, seed);
        const BoardCalibration found = calibrate(board);
        const LensParameter& focal = found.parameters[0];
        if (focal.low <= truth.parameters[0] && truth.parameters[0] <= focal.high) ++held;
    }
    std::cout << held << " of " << kTrials << " intervals hold the truth\n";
    EXPECT_GE(held, 0.92 * kTrials);
    EXPECT_LE(held, 0.98 * kTrials);
}

TEST(BoardCalibration, WrongPointsAndPhotographsDoNotLeadAstray) {
    const Camera truth = lens_named("RADIAL");
    BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 14, 40, 7), 0.1, 5);
    board.views[2].points[7].px += Eigen::Vector2d(12, -8);
    board.views[5].points[20].px += Eigen::Vector2d(-3, 3);
    // A photograph whose board is bent.
    for (BoardPoint& point : board.views[9].points) {
        point.px.x() += 3 * std::sin(point.place.x()) * std::cos(2 * point.place.y());
    }
    const BoardCalibration found = calibrate(board);
    ASSERT_EQ(found.left_out.size(), 1u);
    EXPECT_EQ(found.left_out[0].name, "photograph 9");
    EXPECT_EQ(found.left_out[0].code, "E-BOARD-DISAGREES");
    EXPECT_GE(found.removed_points, 2u);
    EXPECT_NEAR(found.lens.parameters[0], 560, 4 * found.parameters[0].sigma);
}

TEST(BoardCalibration, SizeOfSquaresIsEstimatedWithTheLens) {
    const Camera truth = lens_named("SIMPLE_RADIAL");
    BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 12, 40, 9), 0.05, 5);
    // The same points said in another way: odd columns are half a square of size 0.7 to the right
    // of 0.65 of the way.
    for (BoardView& view : board.views) {
        for (BoardPoint& point : view.points) {
            if (std::lround(point.place.x()) % 2 == 0) continue;
            point.along_size = {0.5, 0.0};
            point.place.x() -= 0.35;
        }
    }
    board.size_per_pitch = 0.6;
    const BoardCalibration found = calibrate(board);
    EXPECT_NEAR(found.size_per_pitch, 0.7, 1e-3);
    EXPECT_NEAR(found.lens.parameters[0], 560, 4 * found.parameters[0].sigma);
}

TEST(BoardCalibration, RefusesTooFewPhotographs) {
    const Camera truth = lens_named("SIMPLE_PINHOLE");
    EXPECT_EQ(code_of_refusal(
                  seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 2, 40, 1), 0.1, 1)),
              "E-BOARDS-TOOFEW");
    EXPECT_EQ(code_of_refusal({}), "E-BOARDS-TOOFEW");
}

TEST(BoardCalibration, RefusesBoardsThatAllFaceTheCamera) {
    const Camera truth = lens_named("SIMPLE_PINHOLE");
    for (const double tilt_deg : {0.0, 1.0, 3.0}) {
        for (std::uint32_t seed = 1; seed <= 2; ++seed) {
            EXPECT_EQ(
                code_of_refusal(seen_chessboards(
                    truth, 9, 6, hand_held_poses(truth, 9, 6, 12, tilt_deg, seed), 0.2, seed)),
                "E-BOARDS-FOCAL")
                << tilt_deg << " degrees, seed " << seed;
        }
    }
}

TEST(BoardCalibration, RefusesPointsThatNoLensExplains) {
    const Camera truth = lens_named("SIMPLE_PINHOLE");
    BoardViews board =
        seen_chessboards(truth, 9, 6, hand_held_poses(truth, 9, 6, 8, 30, 1), 0.0, 1);
    for (BoardView& view : board.views) {
        for (BoardPoint& point : view.points) point.px = Eigen::Vector2d(100, 100);
    }
    EXPECT_THAT(code_of_refusal(board), HasSubstr("E-BOARDS-"));
}

}  // namespace
}  // namespace lumi
