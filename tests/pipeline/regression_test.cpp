#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/regression/version_figures.h"
#include "pipeline/workspace/json_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

TEST(Regression, SaysWhatMovedBeyondTheNoiseOfBoth) {
    const VersionFigures before{{"error.a.flip", {0.100, 0.001, false}},
                                {"error.a.psnr_db", {30.0, 0.1, true}},
                                {"ratio.a", {3.0, 0.2, false}},
                                {"ratio.gone", {3.0, 0.2, false}}};
    const VersionFigures now{{"error.a.flip", {0.103, 0.001, false}},
                             {"error.a.psnr_db", {30.5, 0.1, true}},
                             {"ratio.a", {3.35, 0.2, false}},
                             {"ratio.new", {1.0, 0.2, false}}};
    const std::vector<FigureMove> moves = moves_between(before, now);
    ASSERT_EQ(moves.size(), 2U);
    EXPECT_EQ(moves[0].name, "error.a.flip");
    EXPECT_FALSE(moves[0].is_better);
    EXPECT_EQ(moves[1].name, "error.a.psnr_db");
    EXPECT_TRUE(moves[1].is_better);
    EXPECT_TRUE(moves_between(now, now).empty());
}

TEST(Regression, FiguresAreReadBackAsTheyWereWritten) {
    const ScratchFolder scratch;
    const VersionFigures figures{{"ratio.a", {1.0 / 3.0, 0.1, false}}};
    write_json_file(scratch / "b.json", version_figures_json(figures));
    const VersionFigures again = read_version_figures(scratch / "b.json");
    EXPECT_EQ(again.at("ratio.a").value, 1.0 / 3.0);
    write_whole_text(scratch / "bad.json", "{\"schema_version\": 2, \"figures\": {}}");
    EXPECT_THROW(static_cast<void>(read_version_figures(scratch / "bad.json")), Error);
}

}  // namespace
}  // namespace lumi
