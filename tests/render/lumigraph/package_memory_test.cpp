#include "render/lumigraph/package_memory.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

constexpr std::uint64_t kMib = std::uint64_t{1} << 20;

/// Photographs of a mebibyte as files and three in memory, and depth of two and five.
Manifest manifest_of(std::size_t views) {
    ManifestView view;
    view.camera = pinhole_camera(1024, 1024, 1000);
    view.photograph.bytes = kMib;
    view.depth.emplace();
    view.depth->width_px = 1024;
    view.depth->height_px = 1024;
    view.depth->inverse_depth.bytes = kMib;
    view.depth->confidence.bytes = kMib;
    Manifest manifest;
    manifest.views.assign(views, view);
    return manifest;
}

/// The code of the Error that is thrown; empty when there is none.
std::string code_of_expecting(const Manifest& manifest, const PackageLimits& limits) {
    try {
        expect_readable(manifest, "some.lumi", limits);
    } catch (const Error& error) {
        return error.code();
    }
    return {};
}

TEST(PackageMemory, CountsFilesOnlyWhileTheyAreDecoded) {
    // Eight mebibytes a view stay; five more are held by each thread, with the depth's 16-bit
    // steps.
    EXPECT_EQ(memory_to_read(manifest_of(1000), 1), (8000 + 5) * kMib);
    EXPECT_EQ(memory_to_read(manifest_of(1000), 4), (8000 + 20) * kMib);
    EXPECT_EQ(memory_to_read(manifest_of(2), 4), (16 + 10) * kMib);
}

TEST(PackageMemory, CountsTrianglesAndTheCodeTheyAreDecodedFrom) {
    Manifest manifest = manifest_of(1);
    ManifestDepthMesh& mesh = manifest.views[0].depth->mesh.emplace();
    mesh.code_bytes = 7 * kMib;
    mesh.header.vertices = 1 << 20;
    mesh.header.triangles = {1 << 20, 0, 1 << 20};
    EXPECT_EQ(memory_to_read(manifest, 1), (8 + 12 + 24 + 1 + 7) * kMib);
}

TEST(PackageMemory, OfHugeClaimsIsHugeAndNeverWrapsAround) {
    for (const std::size_t views : {1U, 2U, 3U}) {
        Manifest manifest = manifest_of(views);
        for (ManifestView& view : manifest.views) view.photograph.bytes = UINT64_MAX - 7;
        EXPECT_EQ(memory_to_read(manifest, 4), UINT64_MAX);
        EXPECT_EQ(code_of_expecting(manifest, {}), "E-PACKAGE-BUDGET");
    }
    // Seven terabytes in small files.
    Manifest manifest = manifest_of(9000);
    for (ManifestView& view : manifest.views) view.camera = pinhole_camera(16384, 16384, 1000);
    EXPECT_EQ(code_of_expecting(manifest, {}), "E-PACKAGE-BUDGET");
}

TEST(PackageMemory, MayBeWhatTheMachineHas) {
    EXPECT_GE(PackageLimits{}.max_decoded_bytes, kLeastMemoryOfPackages);
    EXPECT_EQ(PackageLimits{}.max_decoded_bytes, most_memory_of_packages());
    const Manifest manifest = manifest_of(900);
    const std::uint64_t bytes = memory_to_read(manifest, 1);
    EXPECT_EQ(code_of_expecting(manifest, {.max_decoded_bytes = 2 * bytes}), "");
    EXPECT_EQ(code_of_expecting(manifest, {.max_decoded_bytes = bytes - 1}), "E-PACKAGE-BUDGET");
}

TEST(PackageMemory, IsCountedBeforeAPackageIsPutInPlace) {
    const ScratchFolder scratch;
    const std::filesystem::path folder = scratch / "tiny.lumi";
    try {
        write_package(folder, tiny_lumigraph(), tiny_extras(), {.max_decoded_bytes = 1000});
        FAIL() << "a package that nobody could read";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-PACKAGE-BUDGET");
        EXPECT_NE(error.advice().find("[package] max_views"), std::string::npos);
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

}  // namespace
}  // namespace lumi
