#include "tests/house/test_places.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/made_up_repository.h"

namespace lumi {
namespace {

TEST(TestPlaces, MirrorTheRooms) {
    EXPECT_THAT(misplaced_tests(LUMI_SOURCE_DIR), ::testing::IsEmpty());
}

TEST(TestPlaces, AreWrongWhereTheFolderIsNotThatOfWhatIsTested) {
    const MadeUpRepository repository;
    repository.write("calib/lens/camera.h", "");
    repository.write("tests/calib/lens/camera_test.cpp", "");
    repository.write("meshing/warp/disparity.h", "");
    repository.write("tests/meshing/depth/disparity_test.cpp", "");
    repository.write("tests/meshing/depth/whole_ladder_test.cpp", "");
    EXPECT_THAT(misplaced_tests(repository.root()),
                ::testing::ElementsAre(
                    "tests/meshing/depth/disparity_test.cpp: belongs to tests/meshing/warp"));
}

}  // namespace
}  // namespace lumi
