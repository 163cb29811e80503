#include "tests/house/include_rules.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/made_up_repository.h"

namespace lumi {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(House, RoomsIncludeOnlyTheRoomsBeforeThem) {
    const auto includes = include_lines_of_rooms(LUMI_SOURCE_DIR);
    ASSERT_GT(includes.size(), 50u) << "the rooms were not found in " << LUMI_SOURCE_DIR;
    EXPECT_THAT(wrong_directions(includes), IsEmpty());
}

TEST(House, ChaptersIncludeOnlyTheChaptersBeforeThem) {
    EXPECT_THAT(chapters_that_look_ahead(include_lines_of_rooms(LUMI_SOURCE_DIR)), IsEmpty());
}

TEST(House, HandedOnHeadersKeepHeavyLibrariesToThemselves) {
    EXPECT_THAT(heavy_headers_handed_on(include_lines_of_rooms(LUMI_SOURCE_DIR)), IsEmpty());
}

TEST(House, FindsAnIncludeThatPointsTheWrongWay) {
    const MadeUpRepository repository;
    repository.write("calib/work/wrong.h", "#pragma once\n\n#include \"render/frame/frame.h\"\n");
    repository.write("meshing/surface/right.h", "#include \"calib/capture/camera.h\"\n");
    repository.write("render/gl/odd.cpp", "#  include <pipeline/line/line.h>\n");
    repository.write("pipeline/line/tested.cpp", "#include \"tests/truth/box.h\"\n");
    EXPECT_THAT(
        wrong_directions(include_lines_of_rooms(repository.root())),
        ElementsAre("calib/work/wrong.h:3: includes \"render/frame/frame.h\": calib does "
                    "not know render",
                    HasSubstr("pipeline/line/tested.cpp:1: "), HasSubstr("render/gl/odd.cpp:1: ")));
}

TEST(House, FindsAChapterThatLooksAhead) {
    const MadeUpRepository repository;
    repository.write("render/gl/wrong.h", "#include \"render/modes/adaptive.h\"\n");
    repository.write("render/modes/right.h", "#include \"render/gl/program.h\"\n");
    repository.write("render/modes/odd.h", "#include \"render/odds/ends.h\"\n");
    repository.write("calib/doctor/wrong.h", "#include \"calib/poses/pose_stage.h\"\n");
    repository.write("meshing/matching/right.h", "#include \"calib/matching/pairs.h\"\n");
    EXPECT_THAT(
        chapters_that_look_ahead(include_lines_of_rooms(repository.root())),
        ElementsAre("calib/doctor/wrong.h:1: includes \"calib/poses/pose_stage.h\": doctor does "
                    "not know poses",
                    "render/gl/wrong.h:1: includes \"render/modes/adaptive.h\": gl does not "
                    "know modes",
                    HasSubstr("without a place in the order")));
}

TEST(House, FindsAHeavyLibraryInAHandedOnHeader) {
    const MadeUpRepository repository;
    repository.write("calib/capture/heavy.h", "#include <opencv2/core.hpp>\n");
    repository.write("calib/capture/heavy.cpp", "#include <opencv2/core.hpp>\n");
    repository.write("calib/poses/own.h", "#include <ceres/ceres.h>\n");
    repository.write("meshing/surface/heavy.h", "#include <CGAL/Surface_mesh.h>\n");
    const Offences offences = heavy_headers_handed_on(include_lines_of_rooms(repository.root()));
    ASSERT_THAT(offences, SizeIs(2));
    EXPECT_THAT(offences[0], HasSubstr("calib/capture/heavy.h:1"));
    EXPECT_THAT(offences[1], HasSubstr("meshing/surface/heavy.h:1"));
}

}  // namespace
}  // namespace lumi
