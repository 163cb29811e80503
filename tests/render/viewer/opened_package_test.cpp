#include "render/viewer/opened_package.h"

#include <gtest/gtest.h>

#include "render/lumigraph/manifest.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

fs::path package_in(const fs::path& folder, const char* name) {
    fs::create_directories(folder / name);
    put_file(folder / name / kManifestName, "{}");
    return folder / name;
}

TEST(PackageMeantBy, APathIsThePackageItsManifestOrTheFolderAroundIt) {
    const ScratchFolder scratch;
    const fs::path workspace = scratch / "chair";
    const fs::path package = package_in(workspace, "chair.lumi");
    fs::create_directory(workspace / "depth");
    fs::create_directory(workspace / "unfinished.lumi");
    EXPECT_EQ(package_meant_by(package), package);
    EXPECT_EQ(package_meant_by(package / kManifestName), package);
    EXPECT_EQ(package_meant_by(workspace), package);
    package_in(package, "within.lumi");
    EXPECT_EQ(package_meant_by(package), package);
}

TEST(PackageMeantBy, APathThatNamesNoneOrSeveralIsLeftAsItIs) {
    const ScratchFolder scratch;
    put_file(scratch / "a file", "");
    for (const fs::path& path :
         {scratch / "nothing", scratch / "a file", scratch.path(), fs::path()})
        EXPECT_EQ(package_meant_by(path), path);
    package_in(scratch.path(), "one.lumi");
    package_in(scratch.path(), "another.lumi");
    EXPECT_EQ(package_meant_by(scratch.path()), scratch.path());
}

}  // namespace
}  // namespace lumi
