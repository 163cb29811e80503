#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "calib/boards/board_bow.h"
#include "calib/boards/board_calibration.h"
#include "calib/boards/disc_bias.h"
#include "tests/calib/boards/synthetic_boards.h"

namespace lumi {
namespace {

using testing::HasSubstr;

const Camera kSimpleLens{640, 480, LensModel::kSimplePinhole, {560, 322, 237}};
const Camera kRadialLens{1280, 960, LensModel::kRadial, {1120, 644, 474, -0.3, 0.15}};
const Camera kDecentredLens{
    1280, 720, LensModel::kOpenCv, {930, 935, 655, 352, -0.12, 0.05, 0.001, -0.002}};
const Camera kRoundLens{
    1600, 1200, LensModel::kOpenCvFisheye, {480, 480, 806, 594, 0.02, -0.01, 0.004, -0.001}};

const Eigen::Vector2d kMiddle(4, 2.5);

BoardCalibration calibrated(const BoardViews& board, const BoardCalibrationOptions& options = {}) {
    SilentProgress progress;
    return calibrate_boards(board, options, progress);
}

BentSheet sheet_of(const BoardBow& bow, const Eigen::Vector2d& middle = kMiddle) {
    BoardFrame frame;
    frame.middle = middle;
    return [=](const Eigen::Vector2d& place) -> Eigen::Vector3d {
        return on_bent_board(place.x(), place.y(), frame, bow.data());
    };
}

/// Radius of a sheet that is bent by `share` of its `width`.
double radius_for(double share, double width) { return width / (8 * share); }

BoardViews seen(const Camera& lens, int photographs, double noise_px, std::uint32_t seed,
                const BentSheet& sheet) {
    return seen_chessboards(lens, 9, 6, hand_held_poses(lens, 9, 6, photographs, 40, 100 + seed),
                            noise_px, 7 * seed + 1, sheet);
}

/// Without the photographs that show a part of the board, which has another middle.
BoardViews whole_views(BoardViews board) {
    std::erase_if(board.views, [](const BoardView& view) { return view.points.size() < 54; });
    return board;
}

TEST(BentBoards, PlacesKeepTheirDistancesAlongARolledSheet) {
    for (const double turn_rad : {0.0, 0.4, 1.9}) {
        const Eigen::Vector2d across(std::cos(turn_rad), std::sin(turn_rad));
        const double radius = radius_for(0.02, 8);
        const BentSheet exact = rolled_sheet(kMiddle, across, radius);
        const Eigen::Vector3d form(across.x() * across.x(), 2 * across.x() * across.y(),
                                   across.y() * across.y());
        BoardBow bow{};
        Eigen::Map<Eigen::Vector3d>(bow.data()) = form / (2 * radius);
        for (const Eigen::Vector2d& place :
             {Eigen::Vector2d(0, 0), Eigen::Vector2d(8, 1), Eigen::Vector2d(3, 5)}) {
            const Eigen::Vector3d flat(place.x(), place.y(), 0);
            const Eigen::Vector3d bent = sheet_of(bow)(place);
            // The next terms are s^4 / (24 R^3) of height and s^5 / (120 R^4) inwards.
            EXPECT_LT((bent - exact(place)).norm(), std::pow(4.8, 4) / (24 * std::pow(radius, 3)));
            EXPECT_GT((flat - exact(place)).norm(), 10 * (bent - exact(place)).norm());
        }
    }
}

TEST(BentBoards, ABowIsTheSameFromWhereverPhotographsCount) {
    const BoardBow common{0.01, -0.004, 0.006};
    BoardView view;
    view.middle = {3, 1};
    view.turn_rad = std::numbers::pi / 3;
    const Eigen::Vector3d own =
        bow_turned_by(view.turn_rad) * Eigen::Map<const Eigen::Vector3d>(common.data());
    BoardFrame unturned;
    unturned.middle = view.middle;
    for (const Eigen::Vector2d& place : {Eigen::Vector2d(0, 2), Eigen::Vector2d(5, -3)}) {
        const Eigen::Vector3d one =
            on_bent_board(place.x(), place.y(), frame_of(view), common.data());
        const Eigen::Vector3d other = on_bent_board(place.x(), place.y(), unturned, own.data());
        EXPECT_LT((one - other).norm(), 1e-14);
    }
}

class BentBoardsOfLens : public testing::TestWithParam<Camera> {};

TEST_P(BentBoardsOfLens, ExactPointsGiveBackLensAndBow) {
    const Camera& truth = GetParam();
    for (const BoardBow& bow :
         {BoardBow{0.01, 0, 0}, BoardBow{0, 0.006, -0.004}, BoardBow{-0.003, 0.002, -0.012}}) {
        const BoardViews board = whole_views(seen(truth, 40, 0.0, 3, sheet_of(bow)));
        ASSERT_GE(board.views.size(), 8U);
        const BoardCalibration found = calibrated(board, {.models = {truth.model}});
        ASSERT_TRUE(found.bow.has_value());
        EXPECT_EQ(found.removed_points, 0U);
        for (std::size_t index = 0; index < bow.size(); ++index) {
            EXPECT_NEAR(found.bow->per_pitch[index], bow[index], 1e-7);
        }
        for (std::size_t index = 0; index < truth.parameters.size(); ++index) {
            EXPECT_NEAR(found.lens.parameters[index], truth.parameters[index],
                        1e-5 * std::max(1.0, std::abs(truth.parameters[index])))
                << index;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Models, BentBoardsOfLens,
                         testing::Values(kSimpleLens, kRadialLens, kDecentredLens, kRoundLens),
                         [](const auto& lens) { return std::string(name_of(lens.param.model)); });

TEST(BentBoards, HowFarABoardIsBentIsSaidOfItsWidth) {
    const BoardCalibration found = calibrated(
        seen(kRadialLens, 14, 0.1, 5, rolled_sheet(kMiddle, {1, 0}, radius_for(0.01, 8))));
    ASSERT_TRUE(found.bow.has_value());
    EXPECT_NEAR(found.bow->width_pitches, 8, 0.1);
    EXPECT_NEAR(found.bow->share_of_width, 0.01, 4 * found.bow->sigma_share);
    EXPECT_GT(found.bow->sigma_share, 0);
    EXPECT_LT(found.bow->sigma_share, 0.001);
    EXPECT_NEAR(found.bow->depth_pitches, 0.08, 0.01);
}

TEST(BentBoards, FlatBoardsStayFlat) {
    int flat = 0;
    constexpr int kTrials = 40;
    for (std::uint32_t seed = 0; seed < kTrials; ++seed) {
        const Camera& lens = seed % 2 == 0 ? kRadialLens : kSimpleLens;
        const BoardCalibration found = calibrated(seen(lens, 8 + seed % 8, 0.2, seed, {}));
        if (found.bow.has_value()) continue;
        ++flat;
        for (const LensTrial& trial : found.choice.trials) EXPECT_EQ(trial.parameters_beside, 0);
    }
    // As of parameters of a lens, one in twenty passes for two standard deviations by chance.
    EXPECT_GE(flat, kTrials - 4);
}

TEST(BentBoards, IntervalsHoldTheLensOfARolledBoard) {
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        const double turn_rad = 0.5 * seed;
        const double share = seed % 3 == 0 ? 0.003 : seed % 3 == 1 ? 0.01 : 0.02;
        const BoardCalibration found =
            calibrated(seen(kRadialLens, 12, 0.2, seed,
                            rolled_sheet(kMiddle, {std::cos(turn_rad), std::sin(turn_rad)},
                                         (seed % 2 == 0 ? 1 : -1) * radius_for(share, 8))));
        EXPECT_TRUE(found.bow.has_value()) << "seed " << seed;
        for (const std::size_t index : {0U, 1U, 2U}) {
            EXPECT_NEAR(found.lens.parameters[index], kRadialLens.parameters[index],
                        3 * found.parameters[index].sigma)
                << found.parameters[index].name << ", seed " << seed;
        }
        EXPECT_NEAR(found.rms_px, 0.2 * std::sqrt(2.0), 0.03);
    }
}

TEST(BentBoards, ABowIsNotTakenForARicherLens) {
    for (std::uint32_t seed = 0; seed < 6; ++seed) {
        const BoardCalibration found = calibrated(
            seen(kSimpleLens, 14, 0.15, seed, rolled_sheet(kMiddle, {0, 1}, radius_for(0.01, 5))));
        EXPECT_TRUE(found.bow.has_value());
        EXPECT_EQ(name_of(found.lens.model), name_of(LensModel::kSimplePinhole));
    }
}

/// The same points, counted from another one and turned by quarters.
BoardView counted_anew(BoardView view, int quarters, const Eigen::Vector2d& from) {
    for (BoardPoint& point : view.points) {
        for (int quarter = 0; quarter < quarters; ++quarter) {
            point.place = {-point.place.y(), point.place.x()};
        }
        point.place += from;
    }
    return view;
}

TEST(BentBoards, WhereAPhotographCountsFromMakesNoDifference) {
    BoardViews board =
        seen(kRadialLens, 12, 0.2, 2, rolled_sheet(kMiddle, {1, 0}, radius_for(0.01, 8)));
    const BoardCalibration once = calibrated(board);
    for (std::size_t view = 0; view < board.views.size(); ++view) {
        board.views[view] = counted_anew(board.views[view], static_cast<int>(view % 4),
                                         {3.0 * static_cast<double>(view % 3), -2});
    }
    const BoardCalibration again = calibrated(board);
    ASSERT_TRUE(once.bow.has_value());
    ASSERT_TRUE(again.bow.has_value());
    EXPECT_NEAR(again.bow->share_of_width, once.bow->share_of_width, 1e-6);
    EXPECT_NEAR(again.lens.parameters[0], once.lens.parameters[0], 1e-3);
}

TEST(BentBoards, OfASquareBoardTheBowTellsHowPhotographsCount) {
    const BentSheet sheet = rolled_sheet({3, 3}, {1, 0}, radius_for(0.01, 6));
    for (std::uint32_t seed = 0; seed < 4; ++seed) {
        const std::vector<BoardPose> poses = hand_held_poses(kRadialLens, 7, 7, 12, 40, 50 + seed);
        BoardViews board = seen_chessboards(kRadialLens, 7, 7, poses, 0.2, seed, sheet);
        for (std::size_t view = 0; view < board.views.size(); ++view) {
            board.views[view] = counted_anew(board.views[view], static_cast<int>(view % 2), {1, 2});
        }
        const BoardCalibration found = calibrated(board);
        ASSERT_TRUE(found.bow.has_value()) << "seed " << seed;
        EXPECT_NEAR(found.bow->share_of_width, 0.01, 4 * found.bow->sigma_share);
        EXPECT_NEAR(found.lens.parameters[0], 1120, 3 * found.parameters[0].sigma);
        EXPECT_NEAR(found.rms_px, 0.2 * std::sqrt(2.0), 0.03);
    }
}

TEST(BentBoards, DiscsAreSeenWhereTheBowTurnsThem) {
    const BoardBow bow{0.009, 0.001, -0.004};
    std::vector<BoardPose> poses = hand_held_poses(kSimpleLens, 9, 6, 30, 40, 21);
    std::erase_if(poses, [&](const BoardPose& pose) {
        return seen_chessboards(kSimpleLens, 9, 6, {pose}, 0.0, 1).views[0].points.size() < 54;
    });
    ASSERT_GE(poses.size(), 8U);
    BoardViews board = seen_chessboards(kSimpleLens, 9, 6, poses, 0.0, 1, sheet_of(bow));
    board.are_discs = true;
    board.size_per_pitch = 0.7;
    for (BoardView& view : board.views) view.middle = kMiddle;
    const BoardSolution truth{all_free(kSimpleLens.model), kSimpleLens, 0.7, poses, bow, true};
    const BoardViews nearer = without_disc_bias(board, truth);
    for (std::size_t view = 0; view < board.views.size(); ++view) {
        std::vector<BoardPoint>& points = board.views[view].points;
        for (std::size_t point = 0; point < points.size(); ++point) {
            // Centroids lie as far beyond the centres as these were moved.
            points[point].px += points[point].px - nearer.views[view].points[point].px;
        }
    }
    const BoardCalibration found = calibrated(board, {.models = {kSimpleLens.model}});
    ASSERT_TRUE(found.bow.has_value());
    // Corrected by a flat board these would be 0.01 and 0.2 px.
    EXPECT_LT(found.rms_px, 2e-4);
    EXPECT_NEAR(found.lens.parameters[0], 560, 2e-3);
}

TEST(BentBoards, APointThatIsOffInTheLightOfTheBowGoes) {
    BoardViews board =
        seen(kRadialLens, 12, 0.1, 4, rolled_sheet(kMiddle, {1, 0}, radius_for(0.02, 8)));
    // Less than five standard deviations of what a flat board leaves unexplained.
    board.views[3].points[20].px += Eigen::Vector2d(1.5, -1.0);
    const BoardCalibration found = calibrated(board);
    ASSERT_TRUE(found.bow.has_value());
    EXPECT_EQ(found.removed_points, 1U);
    EXPECT_NEAR(found.rms_px, 0.1 * std::sqrt(2.0), 0.015);
}

TEST(BentBoards, ABowThatIsTooLargeIsNamed) {
    const auto warnings_at = [](double share) {
        return calibrated(seen(kRadialLens, 12, 0.1, 4,
                               rolled_sheet(kMiddle, {1, 0}, radius_for(share, 8))))
            .warnings;
    };
    EXPECT_THAT(warnings_at(0.02), testing::Not(testing::Contains(HasSubstr("bow too large"))));
    EXPECT_THAT(warnings_at(0.05), testing::Contains(HasSubstr("bow too large")));
}

TEST(BentBoards, OfMostShapesThatAreNoBowTheIntervalsHold) {
    int held = 0;
    constexpr int kTrials = 24;
    for (std::uint32_t seed = 0; seed < kTrials; ++seed) {
        const double corner = seed % 2 == 0 ? 1 : -1;
        const BoardCalibration found = calibrated(
            seen(kRadialLens, 12, 0.2, seed, [=](const Eigen::Vector2d& place) -> Eigen::Vector3d {
                // One corner is lifted by a hundredth of the width.
                const double from =
                    std::max(0.0, 0.125 * (place.x() - 4) + corner * 0.2 * (place.y() - 2.5) - 0.2);
                return {place.x(), place.y(), 0.08 * from * from / 0.64};
            }));
        const LensParameter& focal = found.parameters[0];
        if (std::abs(focal.value - 1120) < 2.5 * focal.sigma) ++held;
    }
    EXPECT_GE(held, kTrials - 2);
}

}  // namespace
}  // namespace lumi
