#include "meshing/depth_models/imported_depth.h"

#include <gtest/gtest.h>

#include <limits>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

DepthView view_named(const std::string& name) {
    DepthView view;
    view.name = name;
    view.camera = small_camera();
    return view;
}

DepthMap imported(const DepthView& view, const std::filesystem::path& folder) {
    return imported_depth(view, imported_depth_file({view.name}, 0, folder));
}

void expect_refused(const DepthView& view, const std::filesystem::path& folder,
                    const std::string& code) {
    try {
        (void)imported(view, folder);
        ADD_FAILURE() << "expected " << code;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
    }
}

TEST(ImportedDepth, IsTheInverseOfWhatTheFileSays) {
    const ScratchFolder folder;
    FloatImage depth(480, 360, 4.0F);  // Twice the size of the map.
    depth(21, 41) = 0.0F;
    depth(31, 41) = std::numeric_limits<float>::quiet_NaN();
    depth(51, 41) = std::numeric_limits<float>::infinity();
    write_float_tiff(folder.path() / "walk" / "one.tiff", depth);
    const DepthMap map = imported(view_named("walk/one.jpg"), folder.path());
    EXPECT_EQ(map.inverse_depth.width(), 240);
    EXPECT_EQ(map.inverse_depth(0, 0), 0.25F);
    EXPECT_EQ(map.confidence(0, 0), 255);
    EXPECT_EQ(map.confidence(10, 20), 0) << "0 is unknown";
    EXPECT_EQ(map.confidence(15, 20), 0) << "NaN is unknown";
    EXPECT_EQ(map.confidence(25, 20), 255) << "infinitely far is known";
    EXPECT_EQ(map.inverse_depth(25, 20), 0.0F);
}

TEST(ImportedDepth, OfATallPhotographMayBeRoundedInWidth) {
    const ScratchFolder folder;
    DepthView view = view_named("one.jpg");
    view.camera = pinhole_camera(333, 1000, 900.0);
    write_float_tiff(folder.path() / "one.tiff", FloatImage(17, 50, 2.0F));  // Of 16.65 pixels.
    EXPECT_EQ(imported(view, folder.path()).inverse_depth(332, 999), 0.5F);
}

TEST(ImportedDepth, RefusesWhatIsMissingMisshapenOrNegative) {
    const ScratchFolder folder;
    expect_refused(view_named("one.jpg"), folder.path(), "E-DEPTH-MISSING");
    write_float_tiff(folder.path() / "one.tiff", FloatImage(240, 240, 1.0F));
    expect_refused(view_named("one.jpg"), folder.path(), "E-DEPTH-SIZE");
    write_float_tiff(folder.path() / "two.jpg.tif", FloatImage(240, 180, -1.0F));
    expect_refused(view_named("two.jpg"), folder.path(), "E-DEPTH-VALUE");
}

TEST(ImportedDepth, OfTwoPhotographsOfOneStemIsToldByTheWholeName) {
    const ScratchFolder folder;
    const std::vector<std::string> names{"one.jpg", "one.png", "two.jpg"};
    const auto file_of = [&](std::size_t index) {
        return imported_depth_file(names, index, folder.path());
    };
    const FloatImage depth(240, 180, 4.0F);
    write_float_tiff(folder.path() / "one.tiff", depth);
    write_float_tiff(folder.path() / "two.tiff", depth);
    EXPECT_EQ(file_of(2), folder.path() / "two.tiff");
    for (const std::size_t index : {0U, 1U}) {
        try {
            (void)file_of(index);
            ADD_FAILURE() << "expected E-DEPTH-SHARED";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-DEPTH-SHARED") << error.what();
        }
    }
    write_float_tiff(folder.path() / "one.png.tiff", depth);
    EXPECT_EQ(file_of(0), folder.path() / "one.tiff") << "the other one has its own";
    EXPECT_EQ(file_of(1), folder.path() / "one.png.tiff");
}

TEST(ImportedDepth, IsOfTheFirstEndingWhereverItStandsInTheName) {
    const ScratchFolder folder;
    const FloatImage depth(240, 180, 4.0F);
    write_png(folder.path() / "one.jpg.png", GrayImage(240, 180));
    write_float_tiff(folder.path() / "one.tiff", depth);
    EXPECT_EQ(imported_depth_file({"one.jpg"}, 0, folder.path()), folder.path() / "one.tiff");
    write_float_tiff(folder.path() / "two.tiff", depth);
    write_float_tiff(folder.path() / "two.jpg.tiff", depth);
    EXPECT_EQ(imported_depth_file({"two.jpg"}, 0, folder.path()), folder.path() / "two.tiff");
}

TEST(ImportedDepth, WhatIsSharedIsToBeNamedWithItsWholeEnding) {
    const ScratchFolder folder;
    write_whole_text(folder.path() / "one.geometric.bin", "");
    try {
        (void)imported_depth_file({"one.jpg", "one.png"}, 0, folder.path());
        ADD_FAILURE() << "expected E-DEPTH-SHARED";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-SHARED") << error.what();
        EXPECT_EQ(error.advice(), "name depth maps like one.jpg.geometric.bin");
    }
}

TEST(ImportedDepth, OfANameTooLongForAFileIsMissing) {
    const ScratchFolder folder;
    expect_refused(view_named(std::string(300, 'a') + ".jpg"), folder.path(), "E-DEPTH-MISSING");
}

}  // namespace
}  // namespace lumi
