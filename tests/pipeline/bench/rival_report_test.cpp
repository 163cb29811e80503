#include "pipeline/bench/rival_report.h"

#include <gtest/gtest.h>

#include <sstream>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "pipeline/bench/rival_pictures.h"
#include "pipeline/text/hyphenated.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

TEST(RivalReport, ColumnsStandBelowTheirHeadingsHoweverLongANameIs) {
    RivalScene scene;
    scene.rivals.resize(2);
    scene.rivals[0].method = "heigl";
    scene.rivals[1].method = "paper2001";
    scene.rivals[1].settings = "triangles >= 6 px, depths within 0.5 %";
    std::istringstream lines(rivals_text({scene}));
    std::string line;
    std::getline(lines, line);
    std::string heading;
    std::getline(lines, heading);
    ASSERT_EQ(heading.substr(0, 6), "method");
    for (int row = 0; row < 2; ++row) {
        std::getline(lines, line);
        EXPECT_EQ(line.size(), heading.size()) << line;
    }
}

TEST(RivalReport, FilesAreNamedByWordsWithHyphensBetween) {
    EXPECT_EQ(hyphenated("two-plane adaptive"), "two-plane-adaptive");
    EXPECT_EQ(hyphenated("lightfield, "), "lightfield");
    EXPECT_EQ(hyphenated("paper2001, triangles >= 6 px, depths within 0.5 %"),
              "paper2001-triangles-6-px-depths-within-0.5");
    EXPECT_EQ(hyphenated(" - "), "");
}

/// Error code of what is refused; empty where nothing is.
std::string refusal_of_scenes(const std::filesystem::path& folder,
                              const std::vector<std::string>& scenes) {
    try {
        const RivalPictureFiles files(folder, scenes);
        return {};
    } catch (const Error& error) {
        return error.code();
    }
}

TEST(RivalReport, PicturesOfEarlierRunsGiveWayAndOtherFilesDoNot) {
    const ScratchFolder scratch;
    const ColorImage grey(4, 3, {90, 90, 90});
    for (const std::size_t index : {std::size_t{1}, std::size_t{0}}) {
        RivalPictureFiles files(scratch.path(), {"coke"});
        files.write({"coke", "forward warping, ", index, grey});
        files.put_in_place();
    }
    EXPECT_EQ(read_color_image(scratch / "coke/frame-1.forward-warping.png"), grey);
    EXPECT_FALSE(std::filesystem::exists(scratch / "coke/frame-2.forward-warping.png"));
    write_png(scratch / "statue/holiday.png", grey);
    EXPECT_EQ(refusal_of_scenes(scratch.path(), {"coke", "statue"}), "E-OUT-EXISTS");
    EXPECT_EQ(refusal_of_scenes(scratch.path(), {"coke"}), "");
    EXPECT_TRUE(std::filesystem::exists(scratch / "statue/holiday.png"));
}

}  // namespace
}  // namespace lumi
