#include "calib/boards/marker_layout.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lumi {
namespace {

constexpr double kStep_px = 40;

/// As seen after so many quarter turns of the board.
Eigen::Vector2d turned(Eigen::Vector2d px, int quarter_turns) {
    for (int turn = 0; turn < quarter_turns; ++turn) px = {-px.y(), px.x()};
    return px;
}

/// A ChArUco board of 7 by 5 cells, all of it seen.
struct DrawnBoard {
    std::vector<PatternNode> corners;
    std::vector<DarkQuad> quads;
    MarkerFamily family;

    DrawnBoard(bool is_first_cell_bright, int quarter_turns) {
        constexpr int kColumns = 7;
        constexpr int kRows = 5;
        const auto place_px = [&](double column, double row) {
            return turned(kStep_px * Eigen::Vector2d(column, row), quarter_turns);
        };
        for (int row = 1; row < kRows; ++row) {
            for (int column = 1; column < kColumns; ++column) {
                PatternNode& corner = corners.emplace_back();
                corner.px = place_px(column, row);
                corner.cell = {static_cast<int>(std::lround(corner.px.x() / kStep_px)),
                               static_cast<int>(std::lround(corner.px.y() / kStep_px))};
            }
        }
        for (int row = 0; row < kRows; ++row) {
            for (int column = 0; column < kColumns; ++column) {
                const bool is_bright = ((column + row) % 2 == 0) == is_first_cell_bright;
                if (!is_bright) continue;
                const int id = static_cast<int>(quads.size());
                family.markers.push_back({quads.size(), id, 0});
                DarkQuad& quad = quads.emplace_back();
                quad.centre_px = place_px(column + 0.5, row + 0.5);
                quad.corners_px = {
                    place_px(column + 0.2, row + 0.2), place_px(column + 0.8, row + 0.2),
                    place_px(column + 0.8, row + 0.8), place_px(column + 0.2, row + 0.8)};
            }
        }
    }
    [[nodiscard]] std::optional<CharucoLayout> layout() const {
        return charuco_layout(corners, quads, family);
    }
};

TEST(CharucoLayout, IsToldWhicheverWayTheBoardIsTurned) {
    for (const bool is_first_cell_bright : {false, true}) {
        for (int quarter_turns = 0; quarter_turns < 4; ++quarter_turns) {
            const auto layout = DrawnBoard(is_first_cell_bright, quarter_turns).layout();
            ASSERT_TRUE(layout.has_value()) << quarter_turns;
            EXPECT_EQ(layout->columns, 7) << quarter_turns;
            EXPECT_EQ(layout->is_first_cell_bright, is_first_cell_bright) << quarter_turns;
            EXPECT_EQ(layout->markers, is_first_cell_bright ? 18u : 17u) << quarter_turns;
        }
    }
}

TEST(CharucoLayout, SaysNothingOfTheWidthWhereOneRowIsSeen) {
    DrawnBoard board(true, 0);
    board.family.markers.resize(4);  // Of the first row.
    const auto layout = board.layout();
    ASSERT_TRUE(layout.has_value());
    EXPECT_EQ(layout->columns, 0);
    EXPECT_EQ(layout->markers, 4u);
}

TEST(CharucoLayout, IsNotThatOfMarkersInAnyOrder) {
    DrawnBoard board(true, 0);
    for (MarkerReading& marker : board.family.markers) marker.id = marker.id * marker.id % 19;
    EXPECT_FALSE(board.layout().has_value());
}

/// Four columns and three rows, numbered by rows.
struct NumberedGrid {
    std::vector<PatternNode> nodes;
    std::vector<int> ids;

    NumberedGrid() {
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 4; ++column) {
                nodes.emplace_back().cell = {column - 5, row + 2};
                ids.push_back(10 + 4 * row + column);
            }
        }
    }
};

TEST(MarkerGridLayout, IsThatOfAGridNumberedByRows) {
    NumberedGrid grid;
    const auto layout = marker_grid_layout(grid.nodes, grid.ids);
    ASSERT_TRUE(layout.has_value());
    EXPECT_EQ(layout->columns, 4);
    EXPECT_EQ(layout->markers, 12u);
    EXPECT_EQ(layout->agrees, std::vector<bool>(12, true));
    // Turned by a quarter, columns are rows, and one of the two counts backwards.
    for (PatternNode& node : grid.nodes) node.cell = {-node.cell.row, node.cell.column};
    const auto turned = marker_grid_layout(grid.nodes, grid.ids);
    ASSERT_TRUE(turned.has_value());
    EXPECT_EQ(turned->columns, 4);
    EXPECT_EQ(turned->markers, 12u);
}

TEST(MarkerGridLayout, TellsWhichMarkerWasMisread) {
    NumberedGrid grid;
    grid.ids[6] = 99;
    const auto layout = marker_grid_layout(grid.nodes, grid.ids);
    ASSERT_TRUE(layout.has_value());
    EXPECT_EQ(layout->columns, 4);
    EXPECT_EQ(layout->markers, 11u);
    std::vector<bool> agrees(12, true);
    agrees[6] = false;
    EXPECT_EQ(layout->agrees, agrees);
}

TEST(MarkerGridLayout, IsNotThatOfMarkersInAnyOrder) {
    NumberedGrid grid;
    for (int& id : grid.ids) id = id * id % 23;
    EXPECT_FALSE(marker_grid_layout(grid.nodes, grid.ids).has_value());
}

}  // namespace
}  // namespace lumi
