#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/deflate.h"
#include "render/lumigraph/even_exposure.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/quantised_depth.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

std::map<std::string, Bytes> bytes_of_files(const std::filesystem::path& folder) {
    std::map<std::string, Bytes> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        files[entry.path().lexically_relative(folder).string()] = read_whole_file(entry.path());
    }
    return files;
}

class PackageRoundTrip : public testing::Test {
 protected:
    void SetUp() override {
        write_package(folder_, written_, tiny_extras());
        read_ = read_package(folder_);
    }

    ScratchFolder scratch_;
    std::filesystem::path folder_ = scratch_ / "tiny.lumi";
    Lumigraph written_ = tiny_lumigraph();
    Lumigraph read_;
};

TEST_F(PackageRoundTrip, KeepsPhotographsAndConfidenceToTheBit) {
    ASSERT_EQ(read_.views.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read_.views[i].photograph, written_.views[i].photograph);
        EXPECT_EQ(read_.views[i].depth.confidence, written_.views[i].depth.confidence);
    }
}

TEST_F(PackageRoundTrip, KeepsCamerasAndPosesToTheBit) {
    for (std::size_t i = 0; i < 3; ++i) {
        const LumigraphView& a = written_.views[i];
        const LumigraphView& b = read_.views[i];
        EXPECT_EQ(a.name, b.name);
        EXPECT_EQ(a.camera, b.camera);
        EXPECT_EQ(a.cam_from_world.rotation.coeffs(), b.cam_from_world.rotation.coeffs());
        EXPECT_EQ(a.cam_from_world.translation, b.cam_from_world.translation);
        EXPECT_EQ(a.exif_orientation, b.exif_orientation);
    }
    EXPECT_EQ(written_.name, read_.name);
    EXPECT_EQ(written_.near_depth, read_.near_depth);
    EXPECT_EQ(written_.far_depth, read_.far_depth);
}

TEST_F(PackageRoundTrip, KeepsTheCameraMeshToTheBit) {
    EXPECT_EQ(read_.mesh.construction, written_.mesh.construction);
    EXPECT_EQ(read_.mesh.scene_centre_in_world, written_.mesh.scene_centre_in_world);
    EXPECT_EQ(read_.mesh.faces, written_.mesh.faces);
    ASSERT_EQ(read_.mesh.vertices.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(read_.mesh.vertices[i].position_in_world,
                  written_.mesh.vertices[i].position_in_world);
        EXPECT_EQ(read_.mesh.vertices[i].view_index, written_.mesh.vertices[i].view_index);
    }
}

TEST_F(PackageRoundTrip, KeepsDepthMeshes) {
    ASSERT_TRUE(read_.views[0].depth_mesh);
    EXPECT_FALSE(read_.views[1].depth_mesh);
    const DepthMesh& a = *written_.views[0].depth_mesh;
    const DepthMesh& b = *read_.views[0].depth_mesh;
    EXPECT_EQ(a.indices, b.indices);  // Named in order, they keep it.
    EXPECT_EQ(a.kind_begin, b.kind_begin);
    EXPECT_EQ(a.columns, b.columns);
    EXPECT_EQ(a.rows, b.rows);
    EXPECT_EQ(a.wanted_error_px, b.wanted_error_px);
    EXPECT_EQ(a.error_px, b.error_px);
    EXPECT_EQ(a.disparity_px, b.disparity_px);
    ASSERT_EQ(a.vertices.size(), b.vertices.size());
    for (std::size_t i = 0; i < a.vertices.size(); ++i) {
        EXPECT_EQ(a.vertices[i].head<2>(), b.vertices[i].head<2>());
        // Half of a 64th of a pixel.
        const double moved = static_cast<double>(a.vertices[i].z() - b.vertices[i].z());
        EXPECT_LE(std::abs(moved) * a.disparity_px, 1.0 / 128 + 1e-4);
    }
}

TEST_F(PackageRoundTrip, WhatIsDecodedIsCodedWithoutChange) {
    const LumigraphView& view = read_.views[0];
    const CodedDepthMesh coded = encode(*view.depth_mesh, view.camera);
    const CodedDepthMesh again = encode(decode(coded, view.camera, "mesh"), view.camera);
    EXPECT_EQ(coded.bytes, again.bytes);
    EXPECT_EQ(inflated(deflated(coded.bytes), coded.bytes.size(), "mesh"), coded.bytes);
}

TEST_F(PackageRoundTrip, KeepsInverseDepthWithinHalfAStep) {
    for (std::size_t i = 0; i < 2; ++i) {
        const FloatImage& a = written_.views[i].depth.inverse_depth;
        const FloatImage& b = read_.views[i].depth.inverse_depth;
        const auto [low, high] = std::minmax_element(a.pixels().begin(), a.pixels().end());
        const float half_a_step = (*high - *low) / 131070.0F;
        const float rounding = *high * std::numeric_limits<float>::epsilon();
        ASSERT_EQ(b.pixels().size(), a.pixels().size());
        for (std::size_t p = 0; p < a.pixels().size(); ++p) {
            EXPECT_LE(std::abs(a.pixels()[p] - b.pixels()[p]), half_a_step + rounding);
        }
        EXPECT_EQ(*low, *std::min_element(b.pixels().begin(), b.pixels().end()));
        EXPECT_EQ(*high, *std::max_element(b.pixels().begin(), b.pixels().end()));
    }
    EXPECT_TRUE(read_.views[2].depth.inverse_depth.empty());
    EXPECT_TRUE(read_.views[2].depth.confidence.empty());
}

TEST_F(PackageRoundTrip, KeepsConfigurationAndEvidence) {
    const Manifest manifest = read_manifest(folder_);
    EXPECT_EQ(manifest.evidence_json, R"({"poses":{"views":3}})");
    EXPECT_EQ(read_whole_text(folder_ / manifest.config.path), "name = \"tiny\"\n");
}

TEST_F(PackageRoundTrip, KeepsHowManyViewsAreAskedForDepth) {
    EXPECT_EQ(read_.drawing.depth_views, kMaxDepthViews);
    written_.drawing.depth_views = kLeastDepthViews;
    write_package(folder_, written_, tiny_extras());
    EXPECT_EQ(read_package(folder_).drawing.depth_views, kLeastDepthViews);
}

TEST_F(PackageRoundTrip, KeepsForHowManyPixelsDepthIsWorkedOutAtOnce) {
    EXPECT_EQ(read_.drawing.depth_block_px, kLeastDepthBlock_px);
    written_.drawing.depth_block_px = 1.46;
    write_package(folder_, written_, tiny_extras());
    EXPECT_EQ(read_package(folder_).drawing.depth_block_px, 1.46);
}

TEST_F(PackageRoundTrip, KeepsWhetherHolesAreFilled) {
    EXPECT_FALSE(read_.drawing.fills_holes);
    written_.drawing.fills_holes = true;
    write_package(folder_, written_, tiny_extras());
    EXPECT_TRUE(read_package(folder_).drawing.fills_holes);
}

TEST_F(PackageRoundTrip, KeepsWhetherGuessesAreChecked) {
    EXPECT_FALSE(read_.drawing.checks_guesses);
    written_.drawing.checks_guesses = true;
    write_package(folder_, written_, tiny_extras());
    EXPECT_TRUE(read_package(folder_).drawing.checks_guesses);
}

TEST_F(PackageRoundTrip, KeepsWhetherThinThingsAreDrawn) {
    EXPECT_FALSE(read_.drawing.draws_thin);
    written_.drawing.draws_thin = true;
    write_package(folder_, written_, tiny_extras());
    EXPECT_TRUE(read_package(folder_).drawing.draws_thin);
}

TEST_F(PackageRoundTrip, KeepsHowFarDepthIsTrusted) {
    EXPECT_EQ(read_.drawing.occlusion_tolerance_px, kOcclusionTolerance_px);
    written_.drawing.occlusion_tolerance_px = 6;
    write_package(folder_, written_, tiny_extras());
    EXPECT_EQ(read_package(folder_).drawing.occlusion_tolerance_px, 6);
}

TEST_F(PackageRoundTrip, KeepsHowCloselyNoisyDepthIsFollowed) {
    EXPECT_EQ(read_.noisy_depth_error_px, kNoisyDepthError_px);
    written_.noisy_depth_error_px = 0.4;
    write_package(folder_, written_, tiny_extras());
    EXPECT_EQ(read_package(folder_).noisy_depth_error_px, 0.4);
}

TEST_F(PackageRoundTrip, KeepsHowFarTrianglesMayErr) {
    EXPECT_EQ(read_.drawing.triangle_error_px, kTriangleError_px);
    written_.drawing.triangle_error_px = 1.4;
    write_package(folder_, written_, tiny_extras());
    EXPECT_EQ(read_package(folder_).drawing.triangle_error_px, 1.4);
}

TEST_F(PackageRoundTrip, KeepsExposureGainsToTheBitAndEvensThemOutUnlessToldOtherwise) {
    written_.views[1].exposure_gain = {0.5, 1.0 / 3.0, 2.0};
    written_.drawing.fade_beyond_capture = true;
    write_package(folder_, written_, tiny_extras());
    const Lumigraph as_taken = read_package(folder_, {}, Exposures::kAsTaken);
    EXPECT_EQ(as_taken.views[1].exposure_gain, written_.views[1].exposure_gain);
    EXPECT_EQ(as_taken.views[1].photograph, written_.views[1].photograph);
    EXPECT_EQ(as_taken.views[0].exposure_gain, kNoExposureGain);
    EXPECT_TRUE(as_taken.drawing.fade_beyond_capture);
    EXPECT_FALSE(read_.drawing.fade_beyond_capture);

    even_exposures(written_);
    const Lumigraph evened = read_package(folder_);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(evened.views[i].exposure_gain, kNoExposureGain);
        EXPECT_EQ(evened.views[i].photograph, written_.views[i].photograph);
    }
}

TEST_F(PackageRoundTrip, KeepsTheLensFalloffToTheBitAndEvensItOutUnlessToldOtherwise) {
    EXPECT_EQ(read_.light_falloff, 0.0);
    written_.light_falloff = -1.0 / 3.0;
    write_package(folder_, written_, tiny_extras());
    const Lumigraph as_taken = read_package(folder_, {}, Exposures::kAsTaken);
    EXPECT_EQ(as_taken.light_falloff, written_.light_falloff);
    EXPECT_EQ(as_taken.evened_falloff, 0.0);
    EXPECT_EQ(as_taken.views[1].photograph, written_.views[1].photograph);
    const Lumigraph evened = read_package(folder_);
    EXPECT_EQ(evened.light_falloff, 0.0);
    EXPECT_EQ(evened.evened_falloff, written_.light_falloff);
    EXPECT_EQ(evened.views[1].photograph,
              evened_photograph(written_.views[1], written_.light_falloff));
}

TEST_F(PackageRoundTrip, SameInputTwiceGivesTheSameBytesAnywhere) {
    write_package(scratch_ / "elsewhere" / "other name.lumi", written_, tiny_extras());
    const auto here = bytes_of_files(folder_);
    EXPECT_EQ(here.size(), 12U);  // Manifest, mesh, points, config, 3 photographs, 2 x 2 + 1 depth.
    EXPECT_EQ(here, bytes_of_files(scratch_ / "elsewhere" / "other name.lumi"));
}

TEST(QuantisedDepth, KeepsTheEndsAndAConstantMapToTheBit) {
    FloatImage ends(2, 1);
    ends(0, 0) = 0.1F;
    ends(1, 0) = 0.7F;
    EXPECT_EQ(dequantise(quantise(ends)), ends);
    const FloatImage constant(3, 2, 1.0F / 3.0F);
    EXPECT_EQ(dequantise(quantise(constant)), constant);
}

TEST(QuantisedDepth, KeepsInfinitelyFarAtZero) {
    FloatImage depth(3, 1, 0.25F);
    depth(1, 0) = 0.0F;
    EXPECT_EQ(dequantise(quantise(depth))(1, 0), 0.0F);
}

TEST(PackageWriter, RefusesWhatItCouldNotReadBack) {
    const ScratchFolder scratch;
    const auto refused = [&](const std::function<void(Lumigraph&)>& spoil) {
        Lumigraph lumigraph = tiny_lumigraph();
        spoil(lumigraph);
        EXPECT_THROW(write_package(scratch / "x.lumi", lumigraph, tiny_extras()), Error);
        EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    refused([](Lumigraph& l) { l.views.clear(); });
    refused([&](Lumigraph& l) { l.views[0].depth.inverse_depth(2, 2) = nan; });
    refused([](Lumigraph& l) { l.views[0].depth.inverse_depth(2, 2) = -0.1F; });
    refused([](Lumigraph& l) { l.views[0].depth.confidence = GrayImage(2, 2); });
    refused([](Lumigraph& l) { l.views[1].name = l.views[0].name; });
    refused([](Lumigraph& l) { l.views[1].name = ""; });
    refused([](Lumigraph& l) { l.views[1].name = "latin \xe9.jpg"; });
    refused([](Lumigraph& l) { l.views[1].camera.width_px += 1; });
    refused([](Lumigraph& l) { l.views[1].cam_from_world.rotation.w() += 0.1; });
    refused([&](Lumigraph& l) { l.views[1].cam_from_world.translation.x() = HUGE_VAL; });
    refused([](Lumigraph& l) { l.views[1].exif_orientation = 9; });
    refused([](Lumigraph& l) { l.views[1].exposure_gain[2] = 17.0; });
    refused([](Lumigraph& l) { l.views[1].exposure_gain[0] = 0.0; });
    refused([&](Lumigraph& l) { l.views[1].exposure_gain[1] = HUGE_VAL; });
    refused([](Lumigraph& l) { l.light_falloff = 0.01; });
    refused([](Lumigraph& l) { l.light_falloff = -1e9; });
    refused([](Lumigraph& l) { l.light_falloff = -HUGE_VAL; });
    refused([](Lumigraph& l) { l.light_falloff = NAN; });
    refused([](Lumigraph& l) { l.mesh.faces[0][1] = 3; });
    refused([](Lumigraph& l) { l.mesh.vertices[2].view_index = 3; });
    refused([](Lumigraph& l) { l.far_depth = 0.5 * l.near_depth; });
}

TEST(PackageWriter, RefusesEvidenceThatIsNoObject) {
    const ScratchFolder scratch;
    for (const char* evidence : {"", "[]", "{", "{\"a\": 1, \"a\": 2}", "{} {}"}) {
        PackageExtras extras = tiny_extras();
        extras.evidence_json = evidence;
        EXPECT_THROW(write_package(scratch / "x.lumi", tiny_lumigraph(), extras), Error);
    }
    EXPECT_TRUE(std::filesystem::is_empty(scratch.path()));
}

}  // namespace
}  // namespace lumi
