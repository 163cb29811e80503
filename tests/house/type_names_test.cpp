#include "tests/house/type_names.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/house/made_up_repository.h"

namespace lumi {
namespace {

TEST(TypeNames, AreTakenOnceInAllRooms) {
    EXPECT_THAT(type_names_taken_twice(LUMI_SOURCE_DIR), ::testing::IsEmpty());
}

TEST(TypeNames, AreFoundWhereTwoHeadersTakeOne) {
    const MadeUpRepository repository;
    repository.write("calib/a.h", "class Scene;\nstruct Lens {\n    struct Scene {};\n};\n");
    repository.write("meshing/b.h", "template <class T>\nclass Scene final : Base<T> {\n};\n");
    repository.write("meshing/b.cpp", "struct Scene {\n};\n");
    repository.write("pipeline/c.h", "enum class Scene { kA };\n");
    EXPECT_THAT(type_names_taken_twice(repository.root()),
                ::testing::ElementsAre("pipeline/c.h:1: Scene is in meshing/b.h, too"));
}

}  // namespace
}  // namespace lumi
