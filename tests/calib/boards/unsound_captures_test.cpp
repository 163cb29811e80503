#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "calib/boards/board_calibration.h"
#include "calib/boards/board_detection.h"
#include "calib/pictures/image_io.h"
#include "tests/calib/boards/synthetic_boards.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

const Camera kBarrelLens{640, 480, LensModel::kRadial, {560, 322, 237, -0.3, 0.15}};
const Camera kTelephoneLens{4000, 3000, LensModel::kRadial, {3100, 2012, 1488, 0.09, -0.2}};
const Camera kFisheyeLens{
    1600, 1200, LensModel::kOpenCvFisheye, {480, 480, 806, 594, 0.02, -0.01, 0.004, -0.001}};

BoardViews captured(const Camera& lens, int photographs, double tilt_deg, double noise_px,
                    std::uint32_t seed) {
    return seen_chessboards(lens, 9, 6,
                            hand_held_poses(lens, 9, 6, photographs, tilt_deg, 100 + seed),
                            noise_px, 7 * seed + 1);
}

BoardCalibration lens_from(const BoardViews& board) {
    SilentProgress progress;
    return calibrate_boards(board, {}, progress);
}

std::string refusal_of(const BoardViews& board) {
    try {
        return text_of(lens_from(board).form);
    } catch (const Error& error) {
        EXPECT_FALSE(error.advice().empty());
        return error.code();
    }
}

TEST(UnsoundCaptures, OfAFisheyeThatBoardsFaceNoFocalLengthIsTold) {
    for (const std::uint32_t seed : {0U, 1U, 2U, 3U}) {
        EXPECT_EQ(refusal_of(captured(kFisheyeLens, 6, 2, 0.2, seed)), "E-BOARDS-FOCAL")
            << "seed " << seed;
    }
}

TEST(UnsoundCaptures, AFocalLengthIsNoMoreCertainThanTheCoefficientsBesideItLetItBe) {
    int told = 0;
    for (std::uint32_t seed = 0; seed < 10; ++seed) {
        try {
            const BoardCalibration found = lens_from(captured(kFisheyeLens, 6, 8, 0.2, seed));
            ++told;
            EXPECT_NEAR(found.lens.parameters[0], 480, 4 * found.parameters[0].sigma)
                << text_of(found.form) << ", seed " << seed;
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-BOARDS-FOCAL");
        }
    }
    EXPECT_GE(told, 3);
}

TEST(UnsoundCaptures, ThreePhotographsDoNotMakeALensSimplerThanItIs) {
    for (std::uint32_t seed = 0; seed < 20; ++seed) {
        const BoardCalibration found = lens_from(captured(kTelephoneLens, 3, 40, 0.5, seed));
        EXPECT_LT(found.rms_px, 1.0) << text_of(found.form) << ", seed " << seed;
        EXPECT_NEAR(found.lens.parameters[0], 3100, 4 * found.parameters[0].sigma);
    }
}

TEST(UnsoundCaptures, APhotographThatIsThereTwiceCountsOnce) {
    const BoardViews once = captured(kBarrelLens, 8, 40, 0.2, 7);
    BoardViews twice = once;
    for (const BoardView& view : once.views) {
        twice.views.push_back(view);
        BoardView& copy = twice.views.back();
        copy.photograph = "copy of " + view.photograph;
        // As after saving it once more.
        for (BoardPoint& point : copy.points) point.px += Eigen::Vector2d(0.02, -0.01);
    }
    const BoardCalibration found = lens_from(twice);
    EXPECT_EQ(found.views.size(), once.views.size());
    ASSERT_EQ(found.left_out.size(), once.views.size());
    EXPECT_EQ(found.left_out[0].code, "E-BOARD-COPY");
    EXPECT_THAT(found.left_out[0].reason, HasSubstr("photograph 0"));
    EXPECT_DOUBLE_EQ(found.parameters[0].sigma, lens_from(once).parameters[0].sigma);
}

TEST(UnsoundCaptures, HalfOfThePhotographsAtAnotherZoomAreRefused) {
    Camera longer = kBarrelLens;
    longer.parameters[0] *= 2.5;
    std::vector<BoardPose> farther = hand_held_poses(kBarrelLens, 9, 6, 6, 40, 8);
    for (BoardPose& pose : farther) pose[5] *= 2.5;
    BoardViews board = captured(kBarrelLens, 6, 40, 0.1, 7);
    for (BoardView& view : seen_chessboards(longer, 9, 6, farther, 0.1, 6).views) {
        view.photograph += " at another zoom";
        board.views.push_back(std::move(view));
    }
    EXPECT_EQ(refusal_of(board), "E-BOARDS-SEVERAL");
}

TEST(UnsoundCaptures, WhatPhotographsDisagreeAboutIsUncertain) {
    const Camera lens{
        1280, 720, LensModel::kOpenCv, {930, 935, 655, 352, -0.12, 0.05, 0.001, -0.002}};
    for (std::uint32_t seed = 0; seed < 8; ++seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> zoom(0.98, 1.02);
        BoardViews board{lens.width_px, lens.height_px, {}};
        for (BoardPose pose : hand_held_poses(lens, 9, 6, 8, 40, 100 + seed)) {
            Camera zoomed = lens;
            const double factor = zoom(random);
            for (const std::size_t focal : {0U, 1U}) zoomed.parameters[focal] *= factor;
            pose[5] *= factor;
            const auto index = static_cast<std::uint32_t>(board.views.size());
            BoardView view =
                seen_chessboards(zoomed, 9, 6, {pose}, 0.2, 50 * seed + index).views.front();
            view.photograph = std::to_string(index);
            board.views.push_back(std::move(view));
        }
        const BoardCalibration found = lens_from(board);
        EXPECT_NEAR(found.lens.parameters[0], 930, 2.5 * found.parameters[0].sigma)
            << "seed " << seed;
    }
}

TEST(UnsoundCaptures, ABoardThatIsBentOtherwiseThanInABowIsNamed) {
    const std::vector<BoardPose> poses = hand_held_poses(kBarrelLens, 9, 6, 12, 40, 3);
    const auto is_doubted = [&](const BentSheet& sheet) {
        const BoardViews board = seen_chessboards(kBarrelLens, 9, 6, poses, 0.1, 3, sheet);
        const std::vector<std::string> warnings = lens_from(board).warnings;
        return std::any_of(warnings.begin(), warnings.end(), [](const std::string& warning) {
            return warning.find("bent") != std::string::npos;
        });
    };
    EXPECT_FALSE(is_doubted({}));
    // Rolled along its longer side: the middle lies a sixth of a square behind the ends.
    EXPECT_FALSE(is_doubted(rolled_sheet({4, 2.5}, {1, 0}, 50)));
    // Swung by a tenth of a square to either side.
    EXPECT_TRUE(is_doubted([](const Eigen::Vector2d& place) -> Eigen::Vector3d {
        return {place.x(), place.y(), 0.1 * std::sin(0.25 * std::numbers::pi * place.x())};
    }));
}

TEST(UnsoundCaptures, APatternThatIsNotTheOneTakenForIsRefused) {
    BoardViews board = captured(kBarrelLens, 8, 40, 0.1, 3);
    // Shapes of two sizes in turn, of which one corner each was taken as if they were alike.
    for (BoardView& view : board.views) {
        for (BoardPoint& point : view.points) {
            const bool is_odd = std::lround(point.place.x() + point.place.y()) % 2 != 0;
            point.place += Eigen::Vector2d::Constant(is_odd ? 0.12 : 0);
        }
    }
    EXPECT_EQ(refusal_of(board), "E-BOARDS-NOFIT");
}

TEST(UnsoundCaptures, APhotographOfAnotherSizeThanMostIsLeftOutByName) {
    const ScratchFolder folder;
    const std::vector<BoardPose> poses = hand_held_poses(kBarrelLens, 9, 6, 3, 20, 2);
    for (std::size_t index = 0; index < poses.size(); ++index) {
        write_png(folder.path() / (std::to_string(index) + ".png"),
                  photograph_of(printed_chessboard(9, 6), kBarrelLens, poses[index]));
    }
    write_png(folder.path() / "turned.png", GrayImage(480, 640, 90));
    write_png(folder.path() / "small.png", GrayImage(320, 240, 90));
    SilentProgress progress;
    const BoardPhotographs found = find_boards(folder.path(), {}, 1, progress);
    EXPECT_EQ(found.board.width_px, 640);
    EXPECT_EQ(found.board.height_px, 480);
    EXPECT_EQ(found.board.views.size(), 3u);
    ASSERT_EQ(found.left_out.size(), 2u);
    EXPECT_EQ(found.left_out[0].name, "small.png");
    EXPECT_EQ(found.left_out[1].name, "turned.png");
    EXPECT_EQ(found.left_out[1].code, "E-BOARD-SIZE");
    EXPECT_THAT(found.left_out[1].reason, HasSubstr("480 x 640"));
    EXPECT_THAT(found.left_out[1].reason, HasSubstr("turned"));
}

TEST(UnsoundCaptures, AWrongSizeOfSquaresIsNamedWhereNothingFits) {
    BoardViews board = captured(kBarrelLens, 8, 40, 0.1, 3);
    // Corners of squares of half the distance between them, of which 0.3 was said.
    for (BoardView& view : board.views) {
        for (BoardPoint& point : view.points) {
            const Eigen::Vector2d corner = point.place;
            point.place = {std::floor(corner.x() / 2), std::floor(corner.y() / 2)};
            point.along_size = {std::fmod(corner.x(), 2) - 0.5, std::fmod(corner.y(), 2) - 0.5};
        }
    }
    board.is_size_known = true;
    board.size_per_pitch = 0.5;
    EXPECT_LT(lens_from(board).rms_px, 0.2);
    board.size_per_pitch = 0.3;
    try {
        (void)lens_from(board);
        FAIL() << "no square of this board has 0.3";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-BOARDS-NOFIT");
        EXPECT_THAT(error.advice(), HasSubstr("--square-ratio"));
    }
}

TEST(UnsoundCaptures, ABoardLargerThanTheOneDescribedIsSaidToBe) {
    const ScratchFolder folder;
    const BoardPose pose = hand_held_poses(kBarrelLens, 9, 6, 1, 20, 2).front();
    write_png(folder.path() / "0.png", photograph_of(printed_chessboard(9, 6), kBarrelLens, pose));
    SilentProgress progress;
    try {
        (void)find_boards(folder.path(), {.kind = {}, .columns = 8, .rows = 5}, 1, progress);
        FAIL() << "8 x 5 is not what the photograph shows";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-BOARDS-LARGER");
        EXPECT_THAT(error.what(), HasSubstr("larger than the board that was described"));
        EXPECT_THAT(error.advice(), HasSubstr("--size"));
    }
}

}  // namespace
}  // namespace lumi
