#include "calib/colmap/colmap_database.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <cstring>

#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

/// The tables that COLMAP 3.8's `database_creator` makes, as far as they are used.
constexpr const char* kTables = R"(
CREATE TABLE cameras (camera_id INTEGER PRIMARY KEY, model INTEGER, width INTEGER, height INTEGER,
                      params BLOB, prior_focal_length INTEGER);
CREATE TABLE images (image_id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, camera_id INTEGER);
CREATE TABLE keypoints (image_id INTEGER PRIMARY KEY, rows INTEGER, cols INTEGER, data BLOB);
CREATE TABLE two_view_geometries (pair_id INTEGER PRIMARY KEY, rows INTEGER, cols INTEGER,
                                  data BLOB, config INTEGER);
)";

class ColmapDatabase : public testing::Test {
 protected:
    void SetUp() override { execute(kTables); }

    void execute(const std::string& sql) const {
        sqlite3* database = nullptr;
        ASSERT_EQ(sqlite3_open(path().c_str(), &database), SQLITE_OK);
        EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database);
        sqlite3_close(database);
    }
    std::string answer(const std::string& sql) const {
        sqlite3* database = nullptr;
        sqlite3_stmt* statement = nullptr;
        EXPECT_EQ(sqlite3_open(path().c_str(), &database), SQLITE_OK);
        EXPECT_EQ(sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr), SQLITE_OK);
        std::string text;
        while (sqlite3_step(statement) == SQLITE_ROW) {
            for (int column = 0; column < sqlite3_column_count(statement); ++column) {
                const auto* value = sqlite3_column_text(statement, column);
                text += value == nullptr ? "NULL" : reinterpret_cast<const char*>(value);
                text += column + 1 < sqlite3_column_count(statement) ? " " : "\n";
            }
        }
        sqlite3_finalize(statement);
        sqlite3_close(database);
        return text;
    }
    std::filesystem::path path() const { return folder_ / "database.db"; }
    std::string error_code_of_reading(std::size_t expected_pairs) const {
        try {
            static_cast<void>(read_verified_pairs(path(), photographs_, expected_pairs));
        } catch (const Error& error) {
            return error.code();
        }
        return "none";
    }

    ScratchFolder folder_;
    const std::vector<ColmapPhotograph> photographs_{
        {0, {{1.5F, 2.5F}, {3.5F, 4.5F}, {5.5F, 6.5F}}}, {0, {{7.5F, 8.5F}}}, {0, {}}};
    static constexpr long long kPair_1_2 = 2147483647LL + 2;
};

TEST_F(ColmapDatabase, HoldsCamerasImagesAndKeypointsAsColmapReadsThem) {
    fill_colmap_database(path(), {{pinhole_camera(640, 480, 500), true}}, photographs_);
    EXPECT_EQ(answer("SELECT camera_id, model, width, height, length(params), prior_focal_length "
                     "FROM cameras"),
              "1 1 640 480 32 1\n");
    EXPECT_EQ(answer("SELECT image_id, name, camera_id FROM images"),
              "1 000001.png 1\n2 000002.png 1\n3 000003.png 1\n");
    EXPECT_EQ(answer("SELECT image_id, rows, cols, length(data) FROM keypoints"),
              "1 3 2 24\n2 1 2 8\n3 0 2 0\n");
    // 7.5F and 8.5F, little-endian.
    EXPECT_EQ(answer("SELECT hex(data) FROM keypoints WHERE image_id = 2"), "0000F04000000841\n");
}

TEST_F(ColmapDatabase, GivesBackTheVerifiedPairs) {
    // Features 2 and 0 of the photographs match; the second pair has no geometry.
    execute("INSERT INTO two_view_geometries VALUES (" + std::to_string(kPair_1_2) +
            ", 1, 2, X'0200000000000000', 6)");
    execute("INSERT INTO two_view_geometries VALUES (" + std::to_string(kPair_1_2 + 1) +
            ", 0, 2, X'', 1)");
    const auto pairs = read_verified_pairs(path(), photographs_, 2);
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].first, 0);
    EXPECT_EQ(pairs[0].second, 1);
    EXPECT_EQ(pairs[0].configuration, PairConfiguration::kPlanarOrPanoramic);
    EXPECT_EQ(pairs[0].inliers, (std::vector<FeatureMatch>{{2, 0}}));
}

TEST_F(ColmapDatabase, GivesBackThePairsThatWereWritten) {
    const std::vector<VerifiedPair> pairs{
        {0, 1, PairConfiguration::kUncalibrated, {{2, 0}, {1, 0}}},
        {0, 2, PairConfiguration::kPlanar, {}},
    };
    write_verified_pairs(path(), pairs);
    EXPECT_EQ(
        answer("SELECT pair_id, rows, cols, length(data), config FROM two_view_geometries"),
        std::to_string(kPair_1_2) + " 2 2 16 3\n" + std::to_string(kPair_1_2 + 1) + " 0 2 0 4\n");
    const auto read = read_verified_pairs(path(), photographs_, 2);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_EQ(read[0].inliers, pairs[0].inliers);
    EXPECT_EQ(read[0].configuration, PairConfiguration::kUncalibrated);
}

TEST_F(ColmapDatabase, LeavesKeypointsToColmapWhenAsked) {
    fill_colmap_database(path(), {{pinhole_camera(640, 480, 500), true}}, photographs_,
                         KeypointsIn::kNothing);
    EXPECT_EQ(answer("SELECT count(*) FROM images"), "3\n");
    EXPECT_EQ(answer("SELECT count(*) FROM keypoints"), "0\n");
}

TEST_F(ColmapDatabase, GivesBackKeypointsWithOrWithoutTheirShapes) {
    std::vector<ColmapPhotograph> photographs{{0, {}}, {0, {}}};
    // 7.5, 8.5, 1, 0, 0, 1 as floats, little-endian; and 7.5, 8.5 alone.
    execute(
        "INSERT INTO keypoints VALUES (1, 1, 6, "
        "X'0000F040000008410000803F00000000000000000000803F')");
    execute("INSERT INTO keypoints VALUES (2, 1, 2, X'0000F04000000841')");
    read_keypoints(path(), photographs);
    for (const ColmapPhotograph& photograph : photographs) {
        ASSERT_EQ(photograph.keypoints_px.size(), 1u);
        EXPECT_EQ(photograph.keypoints_px[0], Eigen::Vector2f(7.5F, 8.5F));
    }
}

TEST_F(ColmapDatabase, RefusesKeypointsThatContradictThemselves) {
    const std::vector<std::string> rows{"1, 2, 2, X'0000F04000000841'",   // Size of the blob.
                                        "1, -1, 2, X''",                  // Negative size.
                                        "1, 1, 1, X'0000F040'",           // One coordinate.
                                        "1, 1, 2, X'0000C07F00000841'",   // Not a number.
                                        "2, 1, 2, X'0000F04000000841'"};  // None of the first.
    for (const std::string& row : rows) {
        std::vector<ColmapPhotograph> photographs{{0, {}}};
        execute("DELETE FROM keypoints");
        execute("INSERT INTO keypoints VALUES (" + row + ")");
        EXPECT_THROW(read_keypoints(path(), photographs), Error) << row;
    }
}

TEST_F(ColmapDatabase, RefusesPairsThatWereNotJudged) {
    execute("INSERT INTO two_view_geometries VALUES (" + std::to_string(kPair_1_2) +
            ", 1, 2, X'0200000000000000', 2)");
    EXPECT_EQ(error_code_of_reading(1), "none");
    EXPECT_EQ(error_code_of_reading(2), "E-COLMAP-DATABASE");
}

TEST_F(ColmapDatabase, RefusesWhatContradictsItself) {
    const std::vector<std::string> rows{
        std::to_string(kPair_1_2) + ", 2, 2, X'0200000000000000', 2",           // Size of the blob.
        std::to_string(kPair_1_2) + ", -1, 2, X'', 2",                          // Negative size.
        std::to_string(kPair_1_2) + ", 1, 2, X'0300000000000000', 2",           // No such feature.
        std::to_string(kPair_1_2 + 5) + ", 1, 2, X'0200000000000000', 2",       // No such image.
        std::to_string(2 * kPair_1_2 - 2) + ", 1, 2, X'0000000000000000', 2"};  // Ids 2 and 2.
    for (const std::string& row : rows) {
        execute("DELETE FROM two_view_geometries");
        execute("INSERT INTO two_view_geometries VALUES (" + row + ")");
        EXPECT_EQ(error_code_of_reading(1), "E-COLMAP-DATABASE") << row;
    }
}

TEST_F(ColmapDatabase, RefusesAFileThatIsNoDatabase) {
    folder_.put_text("database.db", "this is no database, and long enough to be looked at twice");
    EXPECT_EQ(error_code_of_reading(0), "E-COLMAP-DATABASE");
    std::filesystem::remove(path());
    EXPECT_EQ(error_code_of_reading(0), "E-COLMAP-DATABASE");
}

TEST(ColmapImageName, GoesThereAndBack) {
    for (const int index : {0, 7, 998, 999999, 1234567}) {
        EXPECT_EQ(photograph_index_of(colmap_image_name(index)), index);
    }
    for (const char* name : {"", "000000.png", "1.png", "000001.jpg", "000001", "-00001.png"}) {
        EXPECT_FALSE(photograph_index_of(name).has_value()) << name;
    }
}

}  // namespace
}  // namespace lumi
